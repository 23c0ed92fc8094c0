#pragma once

#include <stiction/elasticity/levels/basis_transformation.h>

namespace stiction
{
  /// The blocks of a slave in N, and the largest of them, to which what is left out is
  /// added, so that translations are exact. @param part of the largest: less is left out.
  BasisTransformation::Blocks blocks_of(const BasisTransformation::Matrix &N,
                                        Eigen::Index slave);
  BasisTransformation::Blocks large_blocks(BasisTransformation::Blocks blocks,
                                           double part);

  /// N with no others but the large blocks of slaves that have more than 100.
  BasisTransformation::Matrix without_small_blocks(const BasisTransformation::Matrix &N,
                                                   double part);
} // namespace stiction
