#include "abaqus_keyword.h"

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
  } // namespace

  std::vector<std::string> abaqus_items(const std::string &line)
  {
    std::vector<std::string> items = dealii::Utilities::split_string_list(line);
    std::transform(items.begin(), items.end(), items.begin(), without_quotes);
    return items;
  }

  AbaqusKeyword::AbaqusKeyword(std::string line, TextScanner &text)
  {
    using dealii::Utilities::trim;
    std::string more;
    while (line.back() == ',' && text.next_line(more))
      line += more;
    for (const std::string &item : dealii::Utilities::split_string_list(line))
      if (name.empty())
        {
          name = upper(item);
          name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
        }
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
    static const std::map<std::string, std::string> keywords = {
      {"*BOUNDARY", "*BOUNDARY"},
      {"*CLOAD", "*CLOAD"},
      {"*CONTACT", "*CONTACT"},
      {"*CONTACTPAIR", "*CONTACT PAIR"},
      {"*COUPLING", "*COUPLING"},
      {"*DLOAD", "*DLOAD"},
      {"*DSLOAD", "*DSLOAD"},
      {"*ELASTIC", "*ELASTIC"},
      {"*EQUATION", "*EQUATION"},
      {"*FRICTION", "*FRICTION"},
      {"*MPC", "*MPC"},
      {"*RIGIDBODY", "*RIGID BODY"},
      {"*TIE", "*TIE"}};
    const auto found = keywords.find(name);
    return found == keywords.end() ? "" : found->second;
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
