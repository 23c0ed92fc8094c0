#include <stiction/base/text/in_words.h>
#include <stiction/base/text/parameter_pattern.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace stiction
{
  using dealii::Utilities::trim;

  std::vector<std::string> choices_of(const std::string &pattern)
  {
    const std::string begin = "[Selection";
    if (pattern.rfind(begin, 0) != 0)
      return {};
    std::vector<std::string> names = dealii::Utilities::split_string_list(
      trim(pattern.substr(begin.size(), pattern.rfind(']') - begin.size())), '|');
    names.erase(std::remove(names.begin(), names.end(), ""), names.end());
    return names;
  }

  std::string in_words(const std::string &pattern)
  {
    const auto inside = [&](const std::string &begin) {
      const std::size_t from = pattern.find(begin) + begin.size();
      return trim(pattern.substr(from, pattern.find_last_of("](") - from));
    };
    const auto range = [](const std::string &text) {
      const std::size_t dots = text.find("...");
      if (dots == std::string::npos)
        return text;
      const std::string low = text.substr(0, dots), high = text.substr(dots + 3);
      if (low.rfind("-MAX", 0) == 0)
        return std::string();
      if (high.rfind("MAX", 0) == 0 || high == "2147483647")
        return " of at least " + low;
      return " from " + low + " to " + high;
    };

    if (!choices_of(pattern).empty())
      return "one of " + in_quotes(choices_of(pattern));
    if (pattern.rfind("[Bool", 0) == 0)
      return "true or false";
    if (pattern.rfind("[Double", 0) == 0)
      return "a number" + range(inside("[Double"));
    if (pattern.rfind("[Integer range", 0) == 0)
      return "an integer" + range(inside("[Integer range"));
    if (pattern == "[Integer]")
      return "an integer";
    if (pattern.rfind("[List", 0) == 0)
      {
        const std::size_t of      = pattern.find('<') + 1;
        const std::size_t to      = pattern.rfind('>');
        const std::size_t n       = pattern.find("...", to) + 3;
        const std::string at_most = pattern.substr(n, pattern.find(' ', n) - n);
        return (at_most == "1" ? "" : at_most + " entries separated by ',', each ") +
               in_words(pattern.substr(of, to - of));
      }
    return pattern;
  }
} // namespace stiction
