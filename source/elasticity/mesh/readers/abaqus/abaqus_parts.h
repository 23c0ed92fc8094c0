#pragma once

#include <stiction/base/text/text_scanner.h>

#include <deal.II/base/point.h>

#include <Eigen/Geometry>

#include <map>
#include <string>
#include <vector>

namespace stiction
{
  /// The parts of an Abaqus file, which its instances put into the assembly.
  class AbaqusParts
  {
  public:
    /// Reads the keywords of the file and goes back to its beginning. Throws InputError
    /// if a part stands twice or has no end.
    explicit AbaqusParts(TextScanner &text);

    /// Whether a part is there only where an instance puts it.
    bool have_instances() const { return n_instances_ > 0; }

    /// Whether there are several instances, or parts that are instances of themselves.
    bool are_several() const
    {
      return (have_instances() ? n_instances_ : places_.size()) > 1;
    }

    /// Where the lines of a part begin. Throws InputError if there is none of the name.
    TextScanner::Place begin(const std::string &part) const;

  private:
    const TextScanner &text_;
    std::map<std::string, TextScanner::Place> places_; // by names in capital letters
    std::size_t n_instances_ = 0;
  };

  /// Where an instance has the points of its part: moved, then turned.
  class AbaqusPlacement
  {
  public:
    /// Takes a line below "*INSTANCE": the first has the three numbers of a translation,
    /// zero where one is left out; the second the seven of a rotation, two points of its
    /// axis and the angle in degrees. Throws InputError if it is another one.
    void add_line(const std::vector<std::string> &items, const TextScanner &text);

    dealii::Point<3> operator()(const dealii::Point<3> &point) const;

  private:
    Eigen::Isometry3d motion_ = Eigen::Isometry3d::Identity();
    unsigned int n_lines_     = 0;
  };
} // namespace stiction
