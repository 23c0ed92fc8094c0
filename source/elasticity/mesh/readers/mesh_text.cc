#include "mesh_text.h"

#include <stiction/base/errors.h>
#include <stiction/base/utf8.h>

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

  MeshText::MeshText(const std::string &file, std::string location)
    : in_(file)
    , location_(std::move(location))
  {
    // a directory opens, but cannot be read
    if (!in_ || (in_.peek(), in_.bad()))
      throw InputError(location_ + ", cannot be read, must be the path of a mesh file.");
    if (in_.eof())
      throw InputError(location_ + ", is empty, must be a mesh file.");
  }

  bool MeshText::read_line()
  {
    line_.clear();
    position_ = 0;
    if (!std::getline(in_, line_))
      return false;
    ++number_;
    return true;
  }

  bool MeshText::next_line(std::string &line)
  {
    if (!read_line())
      return false;
    line = rest_of_line();
    return true;
  }

  std::string MeshText::rest_of_line()
  {
    const std::string rest = trim(line_.substr(position_));
    position_              = line_.size();
    return rest;
  }

  std::string MeshText::word()
  {
    std::size_t first = line_.find_first_not_of(spaces, position_);
    while (first == std::string::npos)
      {
        if (!read_line())
          refuse("the file ends too early");
        first = line_.find_first_not_of(spaces);
      }
    position_ = std::min(line_.find_first_of(spaces, first), line_.size());
    return line_.substr(first, position_ - first);
  }

  std::string MeshText::words(const std::uint64_t n)
  {
    std::string result;
    for (std::uint64_t i = 0; i < n; ++i)
      result += (i == 0 ? "" : " ") + word();
    return result;
  }

  std::int64_t MeshText::integer()
  {
    return to_integer(word());
  }

  std::uint64_t MeshText::count()
  {
    return to_count(word());
  }

  std::int64_t MeshText::to_integer(const std::string &word) const
  {
    std::int64_t value = 0;
    const char *end    = word.data() + word.size();
    const auto result  = std::from_chars(word.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end)
      refuse("'" + word.substr(0, 40) + "' stands where a whole number should");
    return value;
  }

  std::uint64_t MeshText::to_count(const std::string &word) const
  {
    const std::int64_t value = to_integer(word);
    if (value < 0)
      refuse("'" + word + "' stands where a number >= 0 should");
    return static_cast<std::uint64_t>(value);
  }

  double MeshText::to_real(const std::string &word) const
  {
    char *end          = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    // streams, which read it again, do not take hexadecimal digits
    if (word.empty() || *end != '\0' || !(std::abs(value) <= 1e30) ||
        word.find_first_of("xX") != std::string::npos)
      refuse("'" + word.substr(0, 40) + "' stands where a number should");
    return value;
  }

  void MeshText::refuse(const std::string &reason) const
  {
    std::string message =
      location_ + ", line " + std::to_string(number_) + ": " + reason + ".";
    std::replace(message.begin(), message.end(), '\0', '?');
    throw InputError(message);
  }

  unsigned int to_id(const std::int64_t number, const MeshText &text)
  {
    if (number < 0 || number > 999999999)
      text.refuse("'" + std::to_string(number) +
                  "' is no number for a boundary or a material, must be from "
                  "0 to 999999999");
    return static_cast<unsigned int>(number);
  }

  void add_name(const std::string &name, const unsigned int id,
                std::map<std::string, unsigned int> &names, const MeshText &text)
  {
    if (name.empty() || name.find_first_of(":|;#") != std::string::npos ||
        trim(name) != name ||
        std::any_of(name.begin(), name.end(),
                    [](const unsigned char c) { return std::iscntrl(c) != 0; }))
      text.refuse("'" + name +
                  "' is no name that a parameter file could use, must be a "
                  "word or words without ':', '|', ';' and '#'");
    const std::size_t bad = first_byte_not_utf8(name);
    if (bad != std::string::npos)
      text.refuse("byte " + std::to_string(bad + 1) + " of the name '" + name +
                  "' is no UTF-8, names must be in UTF-8, 'iconv -f latin1 -t "
                  "utf-8' makes that of a file in Latin-1");
    if (name.find_first_not_of("0123456789") == std::string::npos &&
        name != std::to_string(id))
      text.refuse("'" + name + "' is the name of number " + std::to_string(id) +
                  ", must not be another number");
    const auto known = names.emplace(name, id);
    if (known.first->second != id)
      text.refuse("'" + name + "' is the name of number " +
                  std::to_string(known.first->second) + " already, must be that of one");
  }
} // namespace stiction
