#include <stiction/qp/methods/active_set_run.h>

#include <algorithm>

namespace stiction
{
  DualMethodResult run_active_set_method(
    qp::ActiveSetMethod &solver, Eigen::VectorXd &x, Eigen::VectorXd &gradient,
    const qp::Scaling &scaling, const StoppingRule &rule,
    const unsigned int products_in_an_iteration, DualMethodStatistics &statistics,
    const std::function<void(const Eigen::VectorXd &)> &show,
    const DualMethod::Observer &observer)
  {
    DualMethodResult result;
    Eigen::VectorXd before = x;
    unsigned int reported  = 0;
    const auto report      = [&](const unsigned int products, const Eigen::VectorXd &now,
                            const double residual) {
      result.change = relative_change(now, before);
      before        = now;
      reported      = products;
      ++result.iterations;
      show(now);
      observer({1, residual, result.change});
    };
    solver.set_observer([&](const unsigned int products, const Eigen::VectorXd &now,
                            const double residual) {
      if (products >= reported + products_in_an_iteration)
        report(products, now, residual);
    });

    const unsigned long cap =
      static_cast<unsigned long>(rule.max_iterations) * products_in_an_iteration;
    const qp::SolverRun run =
      solver.solve(x, gradient, scaling, rule.residual,
                   static_cast<unsigned int>(std::min<unsigned long>(cap, 2000000000)));
    if (run.multiplications > reported)
      report(run.multiplications, x, run.residual);

    statistics += run;
    result.residual  = run.residual;
    result.converged = run.converged;
    result.stagnated = !run.converged && run.multiplications < cap;
    return result;
  }
} // namespace stiction
