#include <stiction/qp/methods/gauss_seidel.h>
#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace stiction
{
  namespace
  {
    // The part of the current error to which an inner program is solved.
    // Between 0.1 and 0.5 the cost is flat; at 0.8 the sweeps stand still.
    constexpr double inner_reduction = 0.1;

    // Far above what an inner program takes; met only when rounding keeps its
    // residual above the tolerance.
    constexpr unsigned int max_inner_multiplications = 500;

    constexpr unsigned int max_newton_steps = 50;

    // Without a new smallest residual for so many sweeps, there is none: the
    // error of a sweep shrinks by about 0.55.
    constexpr unsigned int max_idle_sweeps = 20;
  } // namespace

  GaussSeidel::GaussSeidel(const DualOperator &Q,
                           const std::optional<qp::DiscActiveSet::Variant> variant)
    : Q_(Q)
    , normal_block_(Q.diagonal_block(DualBlock::normal))
    , tangential_block_(Q.diagonal_block(DualBlock::tangential))
    , normal_norm_(qp::spectral_norm(normal_block_))
    , variant_(variant)
  {
    if (!variant)
      disc_newton_ = std::make_unique<qp::SemismoothNewton>(tangential_block_,
                                                            Q.nodal_compliance(), false);
  }

  DualMethodResult GaussSeidel::solve(DualIterate &iterate, const Task &task)
  {
    const qp::SlipBound &slip_bound = task.slip_bound;
    const StoppingRule &rule        = task.rule;
    DualMethodResult result;
    make_feasible(iterate, slip_bound.at(iterate.lambda), Q_);
    result.residual  = task.residual(iterate);
    result.converged = result.residual <= rule.residual;

    double smallest          = result.residual;
    unsigned int idle_sweeps = 0;
    while (!result.converged && !result.stagnated &&
           result.iterations < rule.max_iterations)
      {
        const Eigen::VectorXd before = iterate.lambda;
        const auto tolerance         = [&]() {
          return std::max(inner_reduction * task.residual(iterate), 0.5 * rule.residual);
        };
        normal_half_sweep(iterate, slip_bound, task.scaling, tolerance());
        const Eigen::VectorXd bound = slip_bound.at(iterate.lambda);
        if (slip_bound.is_coulomb())
          make_feasible(iterate, bound, Q_);
        tangential_half_sweep(iterate, bound, task.scaling, tolerance());

        ++result.iterations;
        ++statistics_.gauss_seidel_iterations;
        result.residual = task.residual(iterate);
        result.change   = relative_change(iterate.lambda, before);
        task.observer({1, result.residual, result.change});

        result.converged =
          result.residual <= rule.residual && result.change <= rule.change;
        if (result.converged && disc_newton_)
          {
            // up to here the tangential forces were feasible up to a tolerance
            make_feasible(iterate, slip_bound.at(iterate.lambda), Q_);
            result.residual  = task.residual(iterate);
            result.converged = result.residual <= rule.residual;
          }
        idle_sweeps      = result.residual < 0.9 * smallest ? 0 : idle_sweeps + 1;
        smallest         = std::min(smallest, result.residual);
        result.stagnated = !result.converged && (idle_sweeps >= max_idle_sweeps ||
                                                 !std::isfinite(result.residual));
      }
    if (result.stagnated && !inner_converged_)
      result.reason = "the quadratic programs on discs were not solved in " +
                      std::to_string(max_inner_multiplications) + " products each";
    return result;
  }

  void GaussSeidel::normal_half_sweep(DualIterate &iterate,
                                      const qp::SlipBound &slip_bound,
                                      const qp::Scaling &scaling, const double tolerance)
  {
    const qp::HalfLines half_lines(slip_bound.constant());
    qp::Proportioning solver(normal_block_, half_lines, normal_norm_);
    half_sweep(iterate, DualBlock::normal,
               [&](Eigen::VectorXd &lambda, Eigen::VectorXd &gradient) {
                 add(solver.solve(lambda, gradient, scaling, tolerance,
                                  max_inner_multiplications));
               });
  }

  void GaussSeidel::tangential_half_sweep(DualIterate &iterate,
                                          const Eigen::VectorXd &slip_bound,
                                          const qp::Scaling &scaling,
                                          const double tolerance)
  {
    half_sweep(
      iterate, DualBlock::tangential,
      [&](Eigen::VectorXd &lambda, Eigen::VectorXd &gradient) {
        if (disc_newton_)
          {
            const qp::SolverRun steps = disc_newton_->solve(
              lambda, gradient, qp::SlipBound::given(slip_bound), scaling, tolerance,
              max_newton_steps, [](unsigned int, double) {});
            statistics_ += steps;
            if (steps.converged)
              return;
            ++statistics_.fallbacks;
          }
        if (!tangential_norm_)
          tangential_norm_ = qp::spectral_norm(tangential_block_);
        const qp::Discs discs(slip_bound);
        qp::DiscActiveSet solver(tangential_block_, discs, *tangential_norm_,
                                 variant_.value_or(qp::DiscActiveSet::Variant::spectral));
        add(
          solver.solve(lambda, gradient, scaling, tolerance, max_inner_multiplications));
      });
  }

  void GaussSeidel::add(const qp::SolverRun &inner)
  {
    statistics_ += inner;
    inner_converged_ =
      inner.converged || inner.multiplications < max_inner_multiplications;
  }

  void GaussSeidel::half_sweep(DualIterate &iterate, const DualBlock block,
                               const Solver &solver)
  {
    const Eigen::Index m  = Q_.n_nodes();
    const bool is_normal  = block == DualBlock::normal;
    const DualBlock other = is_normal ? DualBlock::tangential : DualBlock::normal;
    const auto mine       = [&](Eigen::VectorXd &v) {
      return v.segment(is_normal ? 0 : m, is_normal ? m : 2 * m);
    };
    const auto others = [&](Eigen::VectorXd &v) {
      return v.segment(is_normal ? m : 0, is_normal ? 2 * m : m);
    };

    Eigen::VectorXd lambda   = mine(iterate.lambda);
    Eigen::VectorXd gradient = mine(iterate.gradient);
    solver(lambda, gradient);

    const Eigen::VectorXd change = lambda - mine(iterate.lambda);
    if (change.isZero(0.))
      return;
    Eigen::VectorXd coupling;
    Q_.vmult(other, block, coupling, change);
    mine(iterate.lambda)   = lambda;
    mine(iterate.gradient) = gradient;
    others(iterate.gradient) += coupling;
  }
} // namespace stiction
