#include <stiction/contact/newton.h>
#include <stiction/qp/interior_point.h>

#include <algorithm>
#include <functional>
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
  } // namespace



  struct Newton::Run
  {
    DualIterate &iterate;
    const qp::SlipBound &slip_bound;
    const qp::Scaling &scaling;
    const StoppingRule &rule;
    const Observer &observer;
    DualMethodResult result;

    unsigned int
    iterations_left() const
    {
      return rule.max_iterations - result.iterations;
    }

    bool
    is_done() const
    {
      return result.converged || result.iterations >= rule.max_iterations;
    }

    // To be told of each step from here on.
    std::function<void(unsigned int, double)>
    reporter()
    {
      return [this, before = iterate.lambda](unsigned int,
                                             const double residual) mutable {
        result.change = relative_change(iterate.lambda, before);
        before        = iterate.lambda;
        observer({1, residual, result.change});
      };
    }
  };



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
    Run run{iterate, slip_bound, scaling, rule, observer, {}};
    double smallest             = std::numeric_limits<double>::infinity();
    unsigned int idle_fallbacks = 0;
    // where Newton stood still before, it would again, from the same point
    bool is_first_inside = has_stood_still_;
    bool tries_inside    = has_interior_point();
    while (true)
      {
        if (!is_first_inside)
          run_newton(run);
        is_first_inside = false;
        if (run.is_done())
          break;
        if (tries_inside)
          run_interior_point(run);
        tries_inside = false;
        if (run.is_done())
          break;

        const double residual = run.result.residual;
        idle_fallbacks = residual < 0.9 * smallest ? 0 : idle_fallbacks + 1;
        smallest       = std::min(smallest, residual);
        run.result.stagnated = idle_fallbacks > max_idle_fallbacks;
        if (run.result.stagnated)
          break;
        fall_back(run);
        if (run.is_done())
          break;
      }
    return run.result;
  }



  bool
  Newton::has_interior_point() const
  {
    return Q_.matrix() != nullptr && Q_.n_nodes() <= max_nodes_inside;
  }



  void
  Newton::run_newton(Run &run)
  {
    const qp::NewtonStatistics statistics =
      newton_.solve(run.iterate.lambda,
                    run.iterate.gradient,
                    run.slip_bound,
                    run.scaling,
                    run.rule.residual,
                    std::min(max_steps_in_a_run_, run.iterations_left()),
                    run.reporter());
    statistics_.newton_steps += statistics.steps;
    statistics_.krylov_iterations += statistics.krylov_iterations;
    run.result.iterations += statistics.steps;
    run.result.residual  = statistics.residual;
    run.result.converged = statistics.converged;
  }



  void
  Newton::run_interior_point(Run &run)
  {
    has_stood_still_ = true;
    const qp::InteriorPointStatistics statistics =
      qp::InteriorPoint(*Q_.matrix())
        .solve(run.iterate.lambda,
               run.iterate.gradient,
               run.slip_bound,
               run.scaling,
               interior_point_reduction * run.rule.residual,
               run.iterations_left(),
               run.reporter());
    statistics_.interior_point_steps += statistics.steps;
    run.result.iterations += statistics.steps;
    run.result.residual  = statistics.residual;
    run.result.converged = statistics.residual <= run.rule.residual;
  }



  void
  Newton::fall_back(Run &run)
  {
    ++statistics_.fallbacks;
    StoppingRule stretch;
    stretch.residual       = fallback_reduction * run.result.residual;
    stretch.change         = std::numeric_limits<double>::infinity();
    stretch.max_iterations = run.iterations_left();
    const auto bound =
      qp::SlipBound::given(run.slip_bound.at(run.iterate.lambda));
    if (!run.slip_bound.is_coulomb() && !monolithic_)
      monolithic_ = std::make_unique<Monolithic>(Q_);
    DualMethod &method = run.slip_bound.is_coulomb()
                           ? static_cast<DualMethod &>(*this)
                           : *monolithic_;
    run.result.iterations +=
      method.solve(run.iterate, bound, run.scaling, stretch, run.observer)
        .iterations;
  }
} // namespace stiction
