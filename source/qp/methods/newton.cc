#include <stiction/qp/methods/coulomb_fixed_point.h>
#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/methods/newton.h>
#include <stiction/qp/solvers/interior_point.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace stiction
{
  namespace
  {
    // The part of the error that is left to Newton again after a fallback.
    constexpr double fallback_reduction = 0.3;

    // Fallbacks that gain nothing so often running have met rounding, and one
    // more ends the iteration.
    constexpr unsigned int max_idle_fallbacks = 2;

    // A step that is solved directly and one of the interior point method
    // factorise a matrix of three times this order, which takes about 10 s.
    constexpr Eigen::Index max_nodes_factorized = 2000;

    // It starts far away each time, and its last steps gain digits quickly: so
    // much more than asked for is solved at once.
    constexpr double interior_point_reduction = 1e-3;
  } // namespace

  struct Newton::Run
  {
    DualIterate &iterate;
    const Task &task;
    DualMethodResult result = {};

    unsigned int iterations_left() const
    {
      return task.rule.max_iterations - result.iterations;
    }

    bool is_done() const
    {
      return result.converged || result.iterations >= task.rule.max_iterations;
    }

    // To be told of each step from here on.
    std::function<void(unsigned int, double)> reporter()
    {
      return
        [this, before = iterate.lambda](unsigned int, const double residual) mutable {
          result.change = relative_change(iterate.lambda, before);
          before        = iterate.lambda;
          task.observer({1, residual, result.change});
        };
    }
  };

  Newton::Newton(const DualOperator &Q, const unsigned int max_steps_in_a_run)
    : Q_(Q)
    , block_(Q.diagonal_block(DualBlock::all))
    , newton_(block_, Q.nodal_compliance())
    , max_steps_in_a_run_(max_steps_in_a_run)
  {
  }

  DualMethodStatistics Newton::statistics() const
  {
    DualMethodStatistics all = statistics_;
    if (fallback_)
      all += fallback_->statistics();
    return all;
  }

  DualMethodResult Newton::solve(DualIterate &iterate, const Task &task)
  {
    Run run{iterate, task};
    double smallest             = std::numeric_limits<double>::infinity();
    unsigned int idle_fallbacks = 0;
    bool tries_inside           = can_factorize();
    while (true)
      {
        run_newton(run);
        if (run.is_done())
          break;
        if (can_factorize() && !is_direct_)
          {
            newton_.solve_directly(*Q_.matrix());
            is_direct_ = true;
            continue;
          }

        const double residual   = run.result.residual;
        idle_fallbacks          = residual < 0.9 * smallest ? 0 : idle_fallbacks + 1;
        smallest                = std::min(smallest, residual);
        const bool stands_still = idle_fallbacks > max_idle_fallbacks;
        // of several solutions successive approximations lead to the same one
        // as all other methods
        if (tries_inside &&
            (stands_still || !task.slip_bound.may_have_several_solutions()))
          {
            run_interior_point(run);
            tries_inside = false;
          }
        run.result.stagnated = stands_still && !run.is_done();
        if (run.is_done() || run.result.stagnated)
          break;
        fall_back(run);
        if (run.is_done())
          break;
      }
    return run.result;
  }

  bool Newton::can_factorize() const
  {
    return Q_.matrix() != nullptr && Q_.n_nodes() <= max_nodes_factorized;
  }

  void Newton::run_newton(Run &run)
  {
    const qp::SolverRun steps =
      newton_.solve(run.iterate.lambda, run.iterate.gradient, run.task.slip_bound,
                    run.task.scaling, run.task.rule.residual,
                    std::min(max_steps_in_a_run_, run.iterations_left()), run.reporter());
    statistics_ += steps;
    run.result.iterations += steps.newton_steps;
    run.result.residual  = steps.residual;
    run.result.converged = steps.converged;
  }

  void Newton::run_interior_point(Run &run)
  {
    const qp::SolverRun steps =
      qp::InteriorPoint(*Q_.matrix())
        .solve(run.iterate.lambda, run.iterate.gradient, run.task.slip_bound,
               run.task.scaling, interior_point_reduction * run.task.rule.residual,
               run.iterations_left(), run.reporter());
    statistics_ += steps;
    run.result.iterations += steps.interior_point_steps;
    run.result.residual  = steps.residual;
    run.result.converged = steps.residual <= run.task.rule.residual;
  }

  void Newton::fall_back(Run &run)
  {
    ++statistics_.fallbacks;
    if (!fallback_ && !run.task.slip_bound.is_coulomb())
      fallback_ = std::make_unique<Mpgp>(Q_);
    else if (!fallback_)
      fallback_ = std::make_unique<CoulombFixedPoint>(
        std::make_unique<Newton>(Q_, max_steps_in_a_run_));
    Task stretch                          = run.task;
    stretch.rule                          = {fallback_reduction * run.result.residual,
                                             std::numeric_limits<double>::infinity(), run.iterations_left()};
    const DualMethodResult stretch_result = fallback_->solve(run.iterate, stretch);
    run.result.iterations += stretch_result.iterations;
    run.result.residual  = stretch_result.residual;
    run.result.change    = stretch_result.change;
    run.result.converged = stretch_result.residual <= run.task.rule.residual;
  }
} // namespace stiction
