#ifndef stiction_elasticity_stiffness_largest_strain_h
#define stiction_elasticity_stiffness_largest_strain_h

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

namespace stiction
{
  class Body;

  /// The largest principal strain, by its amount, in the middle of any cell, from the
  /// displacement of the corners; what singular stresses do within a cell is left out.
  /// Collective.
  double largest_strain(const Body &body, const LA::Vector &u);
} // namespace stiction

#endif
