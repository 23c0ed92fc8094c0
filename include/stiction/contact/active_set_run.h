#ifndef stiction_contact_active_set_run_h
#define stiction_contact_active_set_run_h

#include <stiction/contact/dual_method.h>
#include <stiction/qp/active_set_method.h>

namespace stiction
{
  /// Runs an active set method on a whole problem, as the outermost iteration.
  ///
  /// @param x, gradient of the quadratic program.
  /// @param products_in_an_iteration what counts as one iteration for the rule
  ///   and for the observer.
  /// @param statistics are added to.
  DualMethodResult
  run_active_set_method(qp::ActiveSetMethod &solver,
                        Eigen::VectorXd &x,
                        Eigen::VectorXd &gradient,
                        const qp::Scaling &scaling,
                        const StoppingRule &rule,
                        unsigned int products_in_an_iteration,
                        DualMethodStatistics &statistics,
                        const DualMethod::Observer &observer);
} // namespace stiction

#endif
