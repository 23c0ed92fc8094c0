#pragma once

#include <string>
#include <vector>

namespace stiction
{
  /// The choices of deal.II's "[Selection a|b|c ]"; none of other patterns.
  std::vector<std::string> choices_of(const std::string &pattern);

  /// What a pattern of deal.II allows: "a number from 0 to 1" for "[Double 0...1
  /// (inclusive)]".
  std::string in_words(const std::string &pattern);
} // namespace stiction
