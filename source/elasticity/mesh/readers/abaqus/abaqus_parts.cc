#include "abaqus_keyword.h"
#include "abaqus_parts.h"

#include <deal.II/base/numbers.h>

namespace stiction
{
  namespace
  {
    // Of an axis: its points must be farther apart, in its unit of length.
    constexpr double same_point = 1e-100;
  } // namespace

  AbaqusParts::AbaqusParts(TextScanner &text)
    : text_(text)
  {
    const TextScanner::Place beginning = text.here();
    std::string line, open;
    bool is_in_assembly             = false;
    const auto require_no_open_part = [&]() {
      if (!open.empty())
        text.refuse("part '" + open + "' has not ended before, must do with '*END PART'");
    };
    while (text.next_line(line))
      {
        if (!AbaqusKeyword::begins(line))
          continue;
        const AbaqusKeyword keyword(line, text);
        if (keyword.name == "*ENDPART")
          open.clear();
        if (keyword.name == "*ASSEMBLY" || keyword.name == "*ENDASSEMBLY")
          is_in_assembly = keyword.name == "*ASSEMBLY";
        if (keyword.name != "*INSTANCE" && keyword.name != "*PART")
          continue;
        require_no_open_part();
        if (keyword.name == "*INSTANCE")
          ++n_instances_;
        else
          {
            open = keyword.value("NAME");
            if (open.empty())
              text.refuse("a part without a name, must be '*PART, NAME=name'");
            if (!places_.emplace(upper(open), text.here()).second)
              text.refuse("part '" + open + "' stands twice");
          }
      }
    require_no_open_part();
    if (is_in_assembly)
      text.refuse("the file ends within the assembly, must do so after '*END ASSEMBLY'");
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
        numbers.push_back(item.empty() ? 0. : text.to_real(item));
    ++n_lines_;
    if (n_lines_ == 1 && numbers.size() <= 3)
      {
        numbers.resize(3, 0.);
        motion_.pretranslate(Eigen::Vector3d(numbers[0], numbers[1], numbers[2]));
      }
    else if (n_lines_ == 2 && numbers.size() == 7)
      {
        const Eigen::Vector3d from(numbers[0], numbers[1], numbers[2]),
          to(numbers[3], numbers[4], numbers[5]);
        if ((to - from).stableNorm() < same_point)
          text.refuse("the points of an axis are the same, must be two");
        const Eigen::AngleAxisd turn(numbers[6] * dealii::numbers::PI / 180.,
                                     (to - from).stableNormalized());
        motion_ =
          Eigen::Translation3d(from) * turn * Eigen::Translation3d(-from) * motion_;
      }
    else
      text.refuse("line " + std::to_string(n_lines_) + " of an instance has " +
                  std::to_string(numbers.size()) +
                  " numbers, must have the three of a translation, and below them the "
                  "seven of a rotation");
  }

  dealii::Point<3> AbaqusPlacement::operator()(const dealii::Point<3> &point) const
  {
    const Eigen::Vector3d moved = motion_ * Eigen::Vector3d(point[0], point[1], point[2]);
    return {moved[0], moved[1], moved[2]};
  }
} // namespace stiction
