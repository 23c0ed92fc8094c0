#pragma once

#include <string>
#include <vector>

namespace stiction
{
  /// " (did you mean 'top'?)" for a word that is close to one of those known,
  /// "" otherwise. Close: at most every third letter has to be changed, added,
  /// left out or exchanged with its neighbour; capitals do not count.
  std::string did_you_mean(const std::string &word,
                           const std::vector<std::string> &known);
} // namespace stiction
