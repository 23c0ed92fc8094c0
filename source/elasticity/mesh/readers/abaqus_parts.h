#ifndef stiction_source_elasticity_mesh_readers_abaqus_parts_h
#define stiction_source_elasticity_mesh_readers_abaqus_parts_h

#include <stiction/base/text/text_scanner.h>

#include <deal.II/base/point.h>

#include <Eigen/Geometry>

#include <map>
#include <string>
#include <vector>

namespace stiction
{
  /// A line of an Abaqus file that begins with a star: "*ELEMENT, TYPE=C3D8".
  struct AbaqusKeyword
  {
    AbaqusKeyword() = default;
    explicit AbaqusKeyword(const std::string &line);

    bool has(const std::string &option) const { return options.count(option) != 0; }

    /// The value of an option, empty if it has none or is not there.
    std::string value(const std::string &option) const;

    std::string name; ///< in capital letters with the star
    /// Names in capital letters, values as they are written.
    std::map<std::string, std::string> options;
  };

  /// The parts of an Abaqus file, which its instances put into the assembly.
  class AbaqusParts
  {
  public:
    /// Reads the keywords of the file and goes back to its beginning.
    explicit AbaqusParts(TextScanner &text);

    /// Whether a part is there only where an instance puts it.
    bool have_instances() const { return n_instances_ > 0; }

    /// Whether there are several instances, or parts that are instances of themselves:
    /// then each has numbers and names of its own.
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
    /// Takes a line below "*INSTANCE": three numbers of a translation, or seven of a
    /// rotation, two points of its axis and the angle in degrees. Throws InputError if
    /// it is neither.
    void add_line(const std::vector<std::string> &items, const TextScanner &text);

    dealii::Point<3> operator()(const dealii::Point<3> &point) const;

  private:
    Eigen::Isometry3d motion_ = Eigen::Isometry3d::Identity();
  };
} // namespace stiction

#endif
