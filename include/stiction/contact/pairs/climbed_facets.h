#pragma once

#include <Eigen/Core>

namespace stiction
{
  /// The energy that a pair has from facets that a surface has climbed, J.
  ///
  /// A sphere or a cylinder slides along itself. Facets wedge: they rise and fall along
  /// the motion, and press the more where they rise. This is ½ Σ λ_i r_i with the rises
  /// r_i = n_i · v(x_i) − mean, where v is of the rigid motions along which the surface
  /// rises by less than 3 degrees the one that fits the slip best. Without their mean the
  /// rises of a taper that is drawn out are zero, as are those of a plane.
  ///
  /// @param positions, normals m × 3, m and unit, towards the other surface
  /// @param slip m × 3, how far each node is displaced from what was opposite, m
  /// @param areas, forces length m, m² and N: normal forces above zero at the nodes to
  ///   look at
  double climbed_facets(const Eigen::MatrixX3d &positions,
                        const Eigen::MatrixX3d &normals, const Eigen::MatrixX3d &slip,
                        const Eigen::VectorXd &areas, const Eigen::VectorXd &forces);
} // namespace stiction
