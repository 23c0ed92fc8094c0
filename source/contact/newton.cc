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

    // A step of the interior point method factorises a matrix of three times
    // this order, which takes about 10 s.
    constexpr Eigen::Index max_nodes_inside = 2000;

    // It starts far away each time, and its last steps gain digits quickly: so
    // much more than asked for is solved at once.
    constexpr double interior_point_reduction = 1e-3;

    // ‖λ − λ_before‖/‖λ‖ from call to call.
    class ChangeOf
    {
    public:
      explicit ChangeOf(const Eigen::VectorXd &lambda)
        : lambda_(lambda)
        , before_(lambda)
      {
      }

      double
      next()
      {
        const double norm   = lambda_.norm();
        const double change = (lambda_ - before_).norm();
        before_             = lambda_;
        return norm > 0. ? change / norm : 0.;
      }

    private:
      const Eigen::VectorXd &lambda_;
      Eigen::VectorXd before_;
    };
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
    // where Newton stood still before, it would again, from the same point
    bool is_first_inside = interior_point_ != nullptr;
    bool tries_inside    = has_interior_point();
    while (true)
      {
        if (!is_first_inside &&
            run_newton(iterate, slip_bound, scaling, rule, observer, result))
          return result;
        is_first_inside = false;
        if (tries_inside &&
            run_interior_point(
              iterate, slip_bound, scaling, rule, observer, result))
          return result;
        tries_inside = false;

        idle_fallbacks =
          result.residual < 0.9 * smallest ? 0 : idle_fallbacks + 1;
        smallest = std::min(smallest, result.residual);
        if (idle_fallbacks > max_idle_fallbacks)
          {
            result.stagnated = true;
            return result;
          }
        if (fall_back(iterate, slip_bound, scaling, rule, observer, result))
          return result;
      }
  }



  bool
  Newton::has_interior_point() const
  {
    return Q_.matrix() != nullptr && Q_.n_nodes() <= max_nodes_inside;
  }



  bool
  Newton::run_newton(DualIterate &iterate,
                     const qp::SlipBound &slip_bound,
                     const qp::Scaling &scaling,
                     const StoppingRule &rule,
                     const Observer &observer,
                     DualMethodResult &result)
  {
    ChangeOf change(iterate.lambda);
    const qp::NewtonStatistics run = newton_.solve(
      iterate.lambda,
      iterate.gradient,
      slip_bound,
      scaling,
      rule.residual,
      std::min(max_steps_in_a_run_, rule.max_iterations - result.iterations),
      [&](unsigned int, const double residual) {
        result.change = change.next();
        observer({1, residual, result.change});
      });
    result.iterations += run.steps;
    statistics_.newton_steps += run.steps;
    statistics_.krylov_iterations += run.krylov_iterations;
    result.residual  = run.residual;
    result.converged = run.converged;
    return run.converged || result.iterations >= rule.max_iterations;
  }



  bool
  Newton::run_interior_point(DualIterate &iterate,
                             const qp::SlipBound &slip_bound,
                             const qp::Scaling &scaling,
                             const StoppingRule &rule,
                             const Observer &observer,
                             DualMethodResult &result)
  {
    if (!interior_point_)
      interior_point_ = std::make_unique<qp::InteriorPoint>(*Q_.matrix());
    ChangeOf change(iterate.lambda);
    const qp::InteriorPointStatistics run =
      interior_point_->solve(iterate.lambda,
                             iterate.gradient,
                             slip_bound,
                             scaling,
                             interior_point_reduction * rule.residual,
                             rule.max_iterations - result.iterations,
                             [&](unsigned int, const double residual) {
                               result.change = change.next();
                               observer({1, residual, result.change});
                             });
    result.iterations += run.steps;
    statistics_.interior_point_steps += run.steps;
    result.residual  = run.residual;
    result.converged = run.residual <= rule.residual;
    return result.converged || result.iterations >= rule.max_iterations;
  }



  bool
  Newton::fall_back(DualIterate &iterate,
                    const qp::SlipBound &slip_bound,
                    const qp::Scaling &scaling,
                    const StoppingRule &rule,
                    const Observer &observer,
                    DualMethodResult &result)
  {
    ++statistics_.fallbacks;
    StoppingRule stretch;
    stretch.residual       = fallback_reduction * result.residual;
    stretch.change         = std::numeric_limits<double>::infinity();
    stretch.max_iterations = rule.max_iterations - result.iterations;
    const auto bound = qp::SlipBound::given(slip_bound.at(iterate.lambda));
    if (slip_bound.is_coulomb())
      result.iterations +=
        solve(iterate, bound, scaling, stretch, observer).iterations;
    else
      {
        if (!monolithic_)
          monolithic_ = std::make_unique<Monolithic>(Q_);
        result.iterations +=
          monolithic_->solve(iterate, bound, scaling, stretch, observer)
            .iterations;
      }
    return result.iterations >= rule.max_iterations;
  }
} // namespace stiction
