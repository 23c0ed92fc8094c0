#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace stiction
{
  /// "x, y and z". There must be one at least.
  std::string listed(const std::vector<std::string> &names);

  /// "'x', 'y', 'z'".
  std::string in_quotes(const std::vector<std::string> &names);

  /// The sentence without the full stop at its end, to go on behind it.
  std::string without_full_stop(std::string sentence);

  /// What a stream writes of these, one behind the other.
  template<typename... Parts> std::string text_of(const Parts &...parts)
  {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
  }
} // namespace stiction
