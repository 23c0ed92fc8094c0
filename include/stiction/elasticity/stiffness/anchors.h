#pragma once

#include <deal.II/base/types.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace stiction
{
  class Body;
  class FreeMotions;

  /// As many unknowns as there are free motions, at vertices, at which only no motion
  /// at all vanishes: chosen one by one where the motions left are largest. Vertices of
  /// the mesh that was refined are taken if these are enough, so that all levels have
  /// them. Collective.
  ///
  /// @param constraints the prescribed displacements and hanging nodes.
  /// @param excluded first unknowns of nodes that are left out if others are enough.
  std::vector<dealii::types::global_dof_index> choose_anchors(
    const Body &body, const dealii::AffineConstraints<double> &constraints,
    const FreeMotions &free_motions,
    const std::vector<dealii::types::global_dof_index> &excluded);
} // namespace stiction
