#pragma once

#include <Eigen/Core>

namespace stiction
{
  class ObstacleMotion;

  /// A direction presses on a contact node if its cosine with −n is above this
  /// one.
  constexpr double least_approach = 0.1;

  /// A first guess of how far pressed obstacles have to go from where the gaps
  /// are these, were nothing to move: to where E √(A/2π) δ is the force, A being
  /// the area that would be cut off by an obstacle δ beyond the place of first
  /// contact. Half of it would be in contact (Hertz), and a flat punch has that
  /// stiffness.
  ///
  /// @param gaps, areas of the contact nodes, m, m².
  /// @param youngs_modulus E, Pa.
  /// @return distances, m, one a pressed obstacle; 0 for one that meets no node.
  Eigen::VectorXd ways_to_press(const ObstacleMotion &motion, const Eigen::VectorXd &gaps,
                                const Eigen::VectorXd &areas, double youngs_modulus);

  /// The contact forces of each pressed obstacle if it pressed alike on all its
  /// nodes, 3m × n, N.
  Eigen::MatrixXd uniform_pressures(const ObstacleMotion &motion,
                                    const Eigen::VectorXd &areas);
} // namespace stiction
