#ifndef stiction_base_text_in_words_h
#define stiction_base_text_in_words_h

#include <string>
#include <vector>

namespace stiction
{
  /// "x, y and z". There must be one at least.
  std::string listed(const std::vector<std::string> &names);

  /// "'x', 'y', 'z'".
  std::string in_quotes(const std::vector<std::string> &names);
} // namespace stiction

#endif
