#include <stiction/base/errors.h>
#include <stiction/base/text/read_line.h>
#include <stiction/base/text/text_scanner.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace stiction
{
  namespace
  {
    constexpr const char *spaces = " \t\r\n\f\v";
  }

  std::string upper(std::string text)
  {
    for (char &c : text)
      c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
  }

  TextScanner::TextScanner(const std::string &file, std::string location,
                           std::string comment)
    : in_(file)
    , location_(std::move(location))
    , comment_(std::move(comment))
  {
    in_.peek(); // a directory opens, but cannot be read
  }

  bool TextScanner::read_line()
  {
    position_ = 0;
    do
      {
        if (!stiction::read_line(in_, line_))
          return false;
        ++line_number_;
      }
    while (!comment_.empty() && line_.rfind(comment_, 0) == 0);
    // a message that quotes it would end there
    std::replace(line_.begin(), line_.end(), '\0', '?');
    std::replace(line_.begin(), line_.end(), '\t', ' ');
    return true;
  }

  bool TextScanner::next_line(std::string &line)
  {
    if (!read_line())
      return false;
    line = rest_of_line();
    return true;
  }

  std::string TextScanner::rest_of_line()
  {
    const std::size_t first = line_.find_first_not_of(spaces, position_);
    position_               = line_.size();
    return first == std::string::npos
             ? ""
             : line_.substr(first, line_.find_last_not_of(spaces) + 1 - first);
  }

  bool TextScanner::next_word()
  {
    std::size_t first = line_.find_first_not_of(spaces, position_);
    while (first == std::string::npos)
      {
        if (!read_line())
          return false;
        first = line_.find_first_not_of(spaces);
      }
    position_ = std::min(line_.find_first_of(spaces, first), line_.size());
    word_.assign(line_, first, position_ - first);
    return true;
  }

  const std::string &TextScanner::word()
  {
    if (!next_word())
      refuse("the file ends too early");
    return word_;
  }

  void TextScanner::skip(std::uint64_t n_words)
  {
    for (; n_words > 0; --n_words)
      word();
  }

  std::int64_t TextScanner::integer() { return to_integer(word()); }

  std::vector<std::int64_t> TextScanner::integers(std::uint64_t n)
  {
    std::vector<std::int64_t> result;
    for (; n > 0; --n)
      result.push_back(integer());
    return result;
  }

  std::uint64_t TextScanner::count() { return to_count(word()); }

  double TextScanner::real() { return to_real(word()); }

  std::int64_t TextScanner::to_integer(const std::string &word) const
  {
    std::int64_t value = 0;
    const char *end    = word.data() + word.size();
    const auto result  = std::from_chars(word.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end)
      refuse("'" + word.substr(0, 40) + "' stands where a whole number should");
    return value;
  }

  std::uint64_t TextScanner::to_count(const std::string &word) const
  {
    const std::int64_t value = to_integer(word);
    if (value < 0)
      refuse("'" + word + "' stands where a number >= 0 should");
    return static_cast<std::uint64_t>(value);
  }

  double TextScanner::to_real(const std::string &word) const
  {
    std::string number = word;
    std::replace(number.begin(), number.end(), 'D', 'e');
    std::replace(number.begin(), number.end(), 'd', 'e');
    char *end          = nullptr;
    const double value = std::strtod(number.c_str(), &end);
    // no hexadecimal digits, which no other program takes in such a file
    if (word.empty() || *end != '\0' || !(std::abs(value) <= 1e30) ||
        word.find_first_of("xX") != std::string::npos)
      refuse("'" + word.substr(0, 40) + "' stands where a number should");
    return value;
  }

  void TextScanner::go_to(const Place &place)
  {
    in_.clear();
    in_.seekg(place.position);
    line_number_ = place.line_number;
  }

  std::string TextScanner::place() const
  {
    return location_ + ", line " + std::to_string(line_number_);
  }

  void TextScanner::refuse(const std::string &reason) const
  {
    throw InputError(place() + ": " + reason + ".");
  }
} // namespace stiction
