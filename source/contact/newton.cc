#include <stiction/contact/newton.h>

#include <algorithm>
#include <limits>

namespace stiction
{
  namespace
  {
    // The part of the error that is left to Newton again after a fallback.
    constexpr double fallback_reduction = 0.3;

    // A fallback that gains nothing twice running has met rounding.
    constexpr unsigned int max_idle_fallbacks = 2;
  } // namespace



  Newton::Newton(const DualOperator &Q, const unsigned int max_steps_in_a_run)
    : Q_(Q)
    , block_(Q, DualBlock::all)
    , newton_(block_, Q.nodal_compliance())
    , max_steps_in_a_run_(max_steps_in_a_run)
  {
  }



  DualMethodStatistics
  Newton::statistics() const
  {
    DualMethodStatistics all = statistics_;
    if (monolithic_)
      {
        const DualMethodStatistics more = monolithic_->statistics();
        all.conjugate_gradient_steps    = more.conjugate_gradient_steps;
        all.expansion_steps             = more.expansion_steps;
        all.release_steps               = more.release_steps;
      }
    return all;
  }



  DualMethodResult
  Newton::solve(DualIterate &iterate,
                const qp::SlipBound &slip_bound,
                const qp::Scaling &scaling,
                const StoppingRule &rule,
                const Observer &observer)
  {
    DualMethodResult result;
    double smallest             = std::numeric_limits<double>::infinity();
    unsigned int idle_fallbacks = 0;
    while (true)
      {
        Eigen::VectorXd before           = iterate.lambda;
        const qp::NewtonStatistics steps = newton_.solve(
          iterate.lambda,
          iterate.gradient,
          slip_bound,
          scaling,
          rule.residual,
          std::min(max_steps_in_a_run_,
                   rule.max_iterations - result.iterations),
          [&](unsigned int, const double residual) {
            const double norm = iterate.lambda.norm();
            result.change =
              norm > 0. ? (iterate.lambda - before).norm() / norm : 0.;
            before = iterate.lambda;
            observer({1, residual, result.change});
          });
        result.iterations += steps.steps;
        statistics_.newton_steps += steps.steps;
        statistics_.krylov_iterations += steps.krylov_iterations;
        result.residual  = steps.residual;
        result.converged = steps.converged;
        if (result.converged || result.iterations >= rule.max_iterations)
          return result;

        idle_fallbacks =
          result.residual < 0.9 * smallest ? 0 : idle_fallbacks + 1;
        smallest = std::min(smallest, result.residual);
        if (idle_fallbacks > max_idle_fallbacks)
          {
            result.stagnated = true;
            return result;
          }

        ++statistics_.fallbacks;
        StoppingRule stretch;
        stretch.residual       = fallback_reduction * result.residual;
        stretch.change         = std::numeric_limits<double>::infinity();
        stretch.max_iterations = rule.max_iterations - result.iterations;
        const auto bound = qp::SlipBound::given(slip_bound.at(iterate.lambda));
        DualMethodResult fallback;
        if (slip_bound.is_coulomb())
          fallback = solve(iterate, bound, scaling, stretch, observer);
        else
          {
            if (!monolithic_)
              monolithic_ = std::make_unique<Monolithic>(Q_);
            fallback =
              monolithic_->solve(iterate, bound, scaling, stretch, observer);
          }
        result.iterations += fallback.iterations;
        if (result.iterations >= rule.max_iterations)
          return result;
      }
  }
} // namespace stiction
