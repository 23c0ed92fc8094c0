#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/lac/affine_constraints.h>

#include <memory>

namespace stiction
{
  class Materials;
  class MeshLevel;

  /// K of any level of the mesh, the constraints eliminated symmetrically: hanging nodes,
  /// whose rows and columns are empty but for a zero on the diagonal (CᵀKC), and where
  /// there are none also prescribed displacements. Unit: N/m. Collective.
  std::unique_ptr<LA::SparseMatrix> assemble_stiffness(
    const MeshLevel &level, const Materials &materials,
    const dealii::AffineConstraints<double> &constraints);
} // namespace stiction
