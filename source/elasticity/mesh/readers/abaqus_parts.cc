#include "abaqus_parts.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

namespace stiction
{
  AbaqusKeyword::AbaqusKeyword(const std::string &line)
  {
    using dealii::Utilities::trim;
    for (const std::string &item : dealii::Utilities::split_string_list(line))
      if (name.empty())
        name = upper(item);
      else
        {
          const std::size_t equals = item.find('=');
          std::string value =
            equals == std::string::npos ? "" : trim(item.substr(equals + 1));
          if (value.size() > 1 && value.front() == '"' && value.back() == '"')
            value = value.substr(1, value.size() - 2);
          options[upper(trim(item.substr(0, equals)))] = value;
        }
  }

  std::string AbaqusKeyword::value(const std::string &option) const
  {
    const auto found = options.find(option);
    return found == options.end() ? "" : found->second;
  }

  AbaqusParts::AbaqusParts(TextScanner &text)
    : text_(text)
  {
    const TextScanner::Place beginning = text.here();
    std::string line;
    while (text.next_line(line))
      {
        if (line.empty() || line[0] != '*' || line.rfind("**", 0) == 0)
          continue;
        const AbaqusKeyword keyword(line);
        if (keyword.name == "*INSTANCE")
          ++n_instances_;
        else if (keyword.name == "*PART" &&
                 !places_.emplace(upper(keyword.value("NAME")), text.here()).second)
          text.refuse("part '" + keyword.value("NAME") + "' stands twice");
      }
    text.go_to(beginning);
  }

  TextScanner::Place AbaqusParts::begin(const std::string &part) const
  {
    const auto found = places_.find(upper(part));
    if (found == places_.end())
      text_.refuse("there is no part '" + part + "', of which the instance above is one");
    return found->second;
  }

  void AbaqusPlacement::add_line(const std::vector<std::string> &items,
                                 const TextScanner &text)
  {
    std::vector<double> numbers;
    for (const std::string &item : items)
      if (!item.empty() || &item != &items.back()) // a line may end with a comma
        numbers.push_back(text.to_real(item));
    if (numbers.size() == 3)
      motion_.pretranslate(Eigen::Vector3d(numbers[0], numbers[1], numbers[2]));
    else if (numbers.size() == 7)
      {
        const Eigen::Vector3d from(numbers[0], numbers[1], numbers[2]),
          to(numbers[3], numbers[4], numbers[5]);
        if (from == to)
          text.refuse("the points of an axis are the same, must be two");
        const Eigen::AngleAxisd turn(numbers[6] * dealii::numbers::PI / 180.,
                                     (to - from).normalized());
        motion_ =
          Eigen::Translation3d(from) * turn * Eigen::Translation3d(-from) * motion_;
      }
    else
      text.refuse("an instance has " + std::to_string(numbers.size()) +
                  " numbers, must have the three of a translation, and below them the "
                  "seven of a rotation");
  }

  dealii::Point<3> AbaqusPlacement::operator()(const dealii::Point<3> &point) const
  {
    const Eigen::Vector3d moved = motion_ * Eigen::Vector3d(point[0], point[1], point[2]);
    return {moved[0], moved[1], moved[2]};
  }
} // namespace stiction
