#include <stiction/base/text/did_you_mean.h>

#include <algorithm>
#include <cctype>

namespace stiction
{
  namespace
  {
    // How many letters have to be changed, added, left out or exchanged with
    // their neighbour (the optimal string alignment distance).
    std::size_t edit_distance(const std::string &a, const std::string &b)
    {
      const auto is_same = [](const char c, const char d) {
        return std::tolower(static_cast<unsigned char>(c)) ==
               std::tolower(static_cast<unsigned char>(d));
      };
      // d[i][j]: of the first i letters of a and the first j of b
      std::vector<std::vector<std::size_t>> d(a.size() + 1,
                                              std::vector<std::size_t>(b.size() + 1));
      for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j)
          {
            if (i == 0 || j == 0)
              {
                d[i][j] = i + j;
                continue;
              }
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1,
                                d[i - 1][j - 1] + (is_same(a[i - 1], b[j - 1]) ? 0 : 1)});
            if (i > 1 && j > 1 && is_same(a[i - 1], b[j - 2]) &&
                is_same(a[i - 2], b[j - 1]))
              d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
          }
      return d[a.size()][b.size()];
    }

    constexpr std::size_t longest_word = 100; // nobody means a longer one
  }                                           // namespace

  std::string did_you_mean(const std::string &word, const std::vector<std::string> &known)
  {
    std::string best;
    std::size_t least = word.size() / 3 + 1;
    if (!word.empty() && word.size() <= longest_word)
      for (const std::string &other : known)
        if (!other.empty() && edit_distance(word, other) < least)
          {
            least = edit_distance(word, other);
            best  = other;
          }
    return best.empty() ? best : " (did you mean '" + best + "'?)";
  }
} // namespace stiction
