#pragma once

#include <cstddef>
#include <string>

namespace stiction
{
  /// The first byte that belongs to no character in UTF-8, npos if there is
  /// none. By Table 3-7 of the Unicode Standard 15.
  std::size_t first_byte_not_utf8(const std::string &text);
} // namespace stiction
