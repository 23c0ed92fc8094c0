#pragma once

#include <stiction/contact/pairs/surface_face.h>

#include <deal.II/base/types.h>

#include <set>
#include <vector>

namespace stiction
{
  /// The parts of a surface that meet at sharp edges alone, such as the six sides of a
  /// block: faces that share a node are in one part if their normals are within 50
  /// degrees, or if both are of a round boundary, however coarse.
  ///
  /// @return of each face the number of its part, in the order of the faces.
  std::vector<unsigned int> smooth_parts(const std::vector<SurfaceFace> &faces);

  /// The nodes at the corners of edges of one face alone, by their first unknowns.
  std::set<dealii::types::global_dof_index> rim_of(const std::vector<SurfaceFace> &faces);
} // namespace stiction
