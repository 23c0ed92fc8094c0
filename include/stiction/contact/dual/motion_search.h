#pragma once

#include <Eigen/Core>

#include <functional>
#include <limits>

namespace stiction
{
  /// Which multipliers of the balance of a body to try next: by Newton's method, whose
  /// step is shortened where it comes no nearer, since other nodes touch or slip there;
  /// if that does not help, those that the method of multipliers makes.
  class MotionSearch
  {
  public:
    /// The next multipliers.
    ///
    /// @param tried the last ones. @param made those that the method of multipliers made
    ///   of them. @param error of the balance with these.
    /// @param newton_step from the last ones; called where it is needed.
    Eigen::VectorXd next(const Eigen::VectorXd &tried, const Eigen::VectorXd &made,
                         double error,
                         const std::function<Eigen::VectorXd()> &newton_step);

  private:
    Eigen::VectorXd from_, made_, step_; ///< of the last step of Newton's method
    double error_ = std::numeric_limits<double>::infinity(); ///< where it began
    double share_ = 0.; ///< of it that was tried; 0: none of it
  };
} // namespace stiction
