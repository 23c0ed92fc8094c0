#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

namespace stiction
{
  class Body;

  /// What linear elasticity takes for small.
  struct Deformation
  {
    double strain   = 0.; ///< the largest principal strain by its amount
    double rotation = 0.; ///< radians
  };

  /// The largest in the middle of any cell, from the displacement of the corners; what
  /// singular stresses do within a cell is left out. Collective.
  Deformation largest_deformation(const Body &body, const LA::Vector &u);
} // namespace stiction
