#pragma once

#include <deal.II/base/point.h>

#include <vector>

namespace stiction
{
  class Body;

  /// The six rigid-body motions of the body as displacements of nodes, three entries
  /// each: three translations, then rotations about x, y, z through the centre of the
  /// bounding box, scaled by half its diagonal so that all six are of size one.
  std::vector<std::vector<double>> rigid_body_modes(
    const Body &body, const std::vector<dealii::Point<3>> &positions);
} // namespace stiction
