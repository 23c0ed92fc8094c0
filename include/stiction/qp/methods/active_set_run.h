#pragma once

#include <stiction/qp/methods/dual_method.h>
#include <stiction/qp/solvers/active_set_method.h>

#include <functional>

namespace stiction
{
  /// Runs an active set method on a whole problem, as the outermost iteration.
  ///
  /// @param x, gradient of the quadratic program.
  /// @param products_in_an_iteration what counts as one iteration for the rule
  ///   and for the observer.
  /// @param statistics are added to.
  /// @param show called with x before the observer is called.
  DualMethodResult run_active_set_method(
    qp::ActiveSetMethod &solver, Eigen::VectorXd &x, Eigen::VectorXd &gradient,
    const qp::Scaling &scaling, const StoppingRule &rule,
    unsigned int products_in_an_iteration, DualMethodStatistics &statistics,
    const std::function<void(const Eigen::VectorXd &)> &show,
    const DualMethod::Observer &observer);
} // namespace stiction
