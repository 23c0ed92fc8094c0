#include <stiction/base/text/in_words.h>

namespace stiction
{
  std::string listed(const std::vector<std::string> &names)
  {
    std::string text = names.front();
    for (std::size_t k = 1; k < names.size(); ++k)
      text += (k + 1 < names.size() ? ", " : " and ") + names[k];
    return text;
  }
} // namespace stiction
