#pragma once

#include <Eigen/Core>

namespace stiction
{
  class DualOperator;

  /// Contact forces λ (N) with the gradient r = Qλ − h (m) that goes with
  /// them: the remaining gaps and the negative slips. Both of length 3m.
  struct DualIterate
  {
    Eigen::VectorXd lambda;
    Eigen::VectorXd gradient;
  };

  /// ‖λ − before‖/‖λ‖, zero for λ = 0.
  double relative_change(const Eigen::VectorXd &lambda, const Eigen::VectorXd &before);

  /// Moves λ to the nearest point with λ_ν ≥ 0 and ‖λ_t,i‖ ≤ g_i, and the
  /// gradient with it; only blocks that change are multiplied.
  void make_feasible(DualIterate &iterate, const Eigen::VectorXd &slip_bound,
                     const DualOperator &Q);
} // namespace stiction
