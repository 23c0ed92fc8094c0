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

  std::string in_quotes(const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "'" : ", '") + name + "'";
    return text;
  }

  std::string without_full_stop(std::string sentence)
  {
    sentence.erase(sentence.find_last_not_of('.') + 1);
    return sentence;
  }
} // namespace stiction
