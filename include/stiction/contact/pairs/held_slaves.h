#pragma once

#include <stiction/contact/pairs/surface_face.h>

#include <stiction/elasticity/linear_algebra/dof_subset.h>

#include <Eigen/Core>

#include <vector>

namespace stiction
{
  class LinearElasticity;
  struct Mortar;

  /// 1 for each unknown that is prescribed, otherwise 0. Collective.
  Eigen::VectorXd prescribed_of(const LinearElasticity &elasticity,
                                const DofSubset &dofs);

  /// How many slaves are held along some axis along which most of what they face is not:
  /// a tie has no hold on that there, since such a slave has no unknown left. Collective.
  unsigned int n_held_alone(const LinearElasticity &elasticity, const Mortar &mortar);

  /// Whether some displacement component is prescribed at a node of these faces that is
  /// no farther from the box around the opposite ones than a cell is large before
  /// refinement. Whole edges and boxes count, so that it is the same after the mesh is
  /// refined. Collective.
  bool is_held(const LinearElasticity &elasticity, const std::vector<SurfaceFace> &faces,
               const std::vector<SurfaceFace> &opposite);
} // namespace stiction
