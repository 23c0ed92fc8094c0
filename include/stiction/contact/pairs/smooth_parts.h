#pragma once

#include <stiction/contact/pairs/surface_face.h>

#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <map>
#include <set>
#include <vector>

namespace stiction
{
  /// The parts of surfaces that meet at sharp edges alone, such as the six sides of a
  /// block: faces that share a node are in one part if their normals are within 50
  /// degrees, or if both are of a round boundary, however coarse.
  class SmoothParts
  {
  public:
    /// The faces of each part of a surface, at least one; remembers which has which.
    std::vector<std::vector<SurfaceFace>> split(const std::vector<SurfaceFace> &faces);

    /// The number of the part that a face is of, 0 for those of no surface that was
    /// split.
    unsigned int of(const dealii::DoFHandler<3>::face_iterator &face) const;

  private:
    /// Of those that are not of part 0, by the first unknowns of the corners, ascending.
    std::map<std::array<dealii::types::global_dof_index, 4>, unsigned int> part_;
  };

  /// The nodes at the corners of edges of one face alone, by their first unknowns.
  std::set<dealii::types::global_dof_index> rim_of(const std::vector<SurfaceFace> &faces);
} // namespace stiction
