#pragma once

#include <Eigen/Core>

namespace stiction::qp
{
  /// A fixed point s = S(s) whose components hardly depend on each other: each goes
  /// along the secant of its last two values (Aitken's Δ²), which damps one that
  /// overshoots and hurries one that creeps.
  class ComponentwiseSecant
  {
  public:
    /// The next s.
    ///
    /// @param s where S was evaluated, of the same length in every call.
    Eigen::VectorXd next(const Eigen::VectorXd &s, const Eigen::VectorXd &S_of_s);

  private:
    Eigen::VectorXd last_s_, last_step_; ///< of the call before, empty at the start
  };
} // namespace stiction::qp
