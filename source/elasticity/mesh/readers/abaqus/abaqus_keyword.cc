#include "abaqus_keyword.h"

#include <stiction/base/text/did_you_mean.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace stiction
{
  namespace
  {
    std::string without_quotes(const std::string &text)
    {
      return text.size() > 1 && text.front() == '"' && text.back() == '"'
               ? text.substr(1, text.size() - 2)
               : text;
    }

    std::string without_spaces(std::string text)
    {
      text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
      return text;
    }
  } // namespace

  std::vector<std::string> abaqus_items(const std::string &line)
  {
    std::vector<std::string> items = dealii::Utilities::split_string_list(line);
    std::transform(items.begin(), items.end(), items.begin(), without_quotes);
    return items;
  }

  void skip_to(const std::string &last, TextScanner &text)
  {
    std::string line;
    while (text.next_line(line))
      if (AbaqusKeyword::begins(line) && AbaqusKeyword(line, text).name == last)
        return;
  }

  AbaqusKeyword::AbaqusKeyword(std::string line, TextScanner &text)
  {
    using dealii::Utilities::trim;
    std::string more;
    while (line.back() == ',' && text.next_line(more))
      line += more;
    for (const std::string &item : dealii::Utilities::split_string_list(line))
      if (name.empty())
        name = without_spaces(upper(item));
      else
        {
          const std::size_t equals = item.find('=');
          options[upper(trim(item.substr(0, equals)))] =
            equals == std::string::npos ? ""
                                        : without_quotes(trim(item.substr(equals + 1)));
        }
  }

  std::string AbaqusKeyword::of_the_problem() const
  {
    for (const char *const keyword :
         {"*BOUNDARY", "*CLOAD", "*CONTACT", "*CONTACT PAIR", "*COUPLING", "*DLOAD",
          "*DSLOAD", "*ELASTIC", "*EQUATION", "*FRICTION", "*MPC", "*RIGID BODY", "*TIE"})
      if (name == without_spaces(keyword))
        return keyword;
    return "";
  }

  std::string AbaqusKeyword::misspelt(const TextScanner &text) const
  {
    const std::vector<std::string> known = {
      "*NODE",    "*ELEMENT",     "*ELSET",       "*SURFACE",     "*PART",
      "*ENDPART", "*INSTANCE",    "*ENDINSTANCE", "*ASSEMBLY",    "*ENDASSEMBLY",
      "*NSET",    "*USERELEMENT", "*USERSURFACE", "*SURFACEFLAW", "*DISTANCE"};
    if (std::find(known.begin(), known.end(), name) != known.end())
      return "";
    const std::string other = did_you_mean(name, known);
    return other.empty() ? ""
                         : "line " + std::to_string(text.line_number()) +
                             " is passed over, its keyword is '" + name + "'" + other;
  }

  void AbaqusKeyword::require_all_is_here(const TextScanner &text) const
  {
    if (name == "*INCLUDE" || ((name == "*NODE" || name == "*ELEMENT") && has("INPUT")))
      text.refuse("another file is included, must be one file");
    if (name == "*SYSTEM" || (name == "*NODE" && has("SYSTEM")))
      text.refuse("coordinates are in another system, must be Cartesian ones");
    if (name == "*NGEN" || name == "*NFILL" || name == "*NCOPY" || name == "*NMAP" ||
        name == "*ELGEN" || name == "*ELCOPY")
      text.refuse("nodes or elements are made by " + name +
                  ", must be written one by one");
  }

  std::string AbaqusKeyword::value(const std::string &option) const
  {
    const auto found = options.find(option);
    return found == options.end() ? "" : found->second;
  }
} // namespace stiction
