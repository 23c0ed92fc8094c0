#pragma once

#include <istream>
#include <string>

namespace stiction
{
  /// What some editors put before text in UTF-8.
  inline const std::string byte_order_mark = "\xef\xbb\xbf";

  /// As std::getline, for text of any system: lines end with LF, CR LF or CR alone, and a
  /// byte order mark before a line is passed over.
  bool read_line(std::istream &in, std::string &line);
} // namespace stiction
