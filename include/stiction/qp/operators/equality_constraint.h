#pragma once

#include <Eigen/Core>

namespace stiction
{
  /// Gᵀλ = e for contact forces λ. What it stands for moves the gaps by Gα, α being
  /// its multipliers: e is −P of the force P that presses an obstacle on, or minus the
  /// work of the loads along a rigid motion of the body.
  struct EqualityConstraint
  {
    Eigen::MatrixXd G; ///< 3m × n
    Eigen::VectorXd e; ///< N, length n
  };
} // namespace stiction
