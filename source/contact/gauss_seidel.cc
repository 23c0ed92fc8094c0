#include <stiction/contact/gauss_seidel.h>
#include <stiction/qp/feasible_set.h>
#include <stiction/qp/proportioning.h>
#include <stiction/qp/spectral_norm.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    // The part of the current error to which an inner program is solved.
    // Between 0.1 and 0.5 the cost is flat; at 0.8 the sweeps stand still.
    constexpr double inner_reduction = 0.3;

    // Far above what an inner program takes; met only when rounding keeps its
    // residual above the tolerance.
    constexpr unsigned int max_inner_multiplications = 500;

    // Without a new smallest residual for so many sweeps, there is none: the
    // error of a sweep shrinks by about 0.55.
    constexpr unsigned int max_idle_sweeps = 20;
  } // namespace



  GaussSeidel::GaussSeidel(const DualOperator &Q,
                           const qp::DiscActiveSet::Variant variant)
    : Q_(Q)
    , normal_block_(Q, DualBlock::normal)
    , tangential_block_(Q, DualBlock::tangential)
    , normal_norm_(qp::spectral_norm(normal_block_))
    , tangential_norm_(qp::spectral_norm(tangential_block_))
    , variant_(variant)
  {
  }



  DualMethodResult
  GaussSeidel::solve(DualIterate &iterate,
                     const qp::SlipBound &slip_bound,
                     const qp::Scaling &scaling,
                     const StoppingRule &rule,
                     const Observer &observer)
  {
    const auto residual = [&]() {
      return qp::HalfLinesTimesDiscs(slip_bound.at(iterate.lambda))
        .natural_residual(iterate.lambda, iterate.gradient, scaling);
    };

    DualMethodResult result;
    make_feasible(iterate, slip_bound.at(iterate.lambda), Q_);
    result.residual  = residual();
    result.converged = result.residual <= rule.residual;

    double smallest          = result.residual;
    unsigned int idle_sweeps = 0;
    while (!result.converged && !result.stagnated &&
           result.iterations < rule.max_iterations)
      {
        const Eigen::VectorXd before = iterate.lambda;
        const double tolerance       = inner_reduction * result.residual;
        normal_half_sweep(iterate, scaling, tolerance);
        const Eigen::VectorXd bound = slip_bound.at(iterate.lambda);
        if (slip_bound.is_coulomb())
          make_feasible(iterate, bound, Q_);
        tangential_half_sweep(iterate, bound, scaling, tolerance);

        ++result.iterations;
        ++statistics_.gauss_seidel_iterations;
        result.residual   = residual();
        const double norm = iterate.lambda.norm();
        result.change =
          norm > 0. ? (iterate.lambda - before).norm() / norm : 0.;
        observer({1, result.residual, result.change});

        result.converged =
          result.residual <= rule.residual && result.change <= rule.change;
        idle_sweeps = result.residual < 0.9 * smallest ? 0 : idle_sweeps + 1;
        smallest    = std::min(smallest, result.residual);
        result.stagnated =
          !result.converged &&
          (idle_sweeps >= max_idle_sweeps || !std::isfinite(result.residual));
      }
    return result;
  }



  void
  GaussSeidel::normal_half_sweep(DualIterate &iterate,
                                 const qp::Scaling &scaling,
                                 const double tolerance)
  {
    const qp::HalfLines half_lines(Q_.n_nodes());
    qp::Proportioning solver(normal_block_, half_lines, normal_norm_);
    half_sweep(iterate, DualBlock::normal, solver, scaling, tolerance);
  }



  void
  GaussSeidel::tangential_half_sweep(DualIterate &iterate,
                                     const Eigen::VectorXd &slip_bound,
                                     const qp::Scaling &scaling,
                                     const double tolerance)
  {
    const qp::Discs discs(slip_bound);
    qp::DiscActiveSet solver(
      tangential_block_, discs, tangential_norm_, variant_);
    half_sweep(iterate, DualBlock::tangential, solver, scaling, tolerance);
  }



  void
  GaussSeidel::half_sweep(DualIterate &iterate,
                          const DualBlock block,
                          qp::ActiveSetMethod &solver,
                          const qp::Scaling &scaling,
                          const double tolerance)
  {
    const Eigen::Index m = Q_.n_nodes();
    const bool is_normal = block == DualBlock::normal;
    const DualBlock other =
      is_normal ? DualBlock::tangential : DualBlock::normal;
    const auto mine = [&](Eigen::VectorXd &v) {
      return v.segment(is_normal ? 0 : m, is_normal ? m : 2 * m);
    };
    const auto others = [&](Eigen::VectorXd &v) {
      return v.segment(is_normal ? m : 0, is_normal ? 2 * m : m);
    };

    Eigen::VectorXd lambda              = mine(iterate.lambda);
    Eigen::VectorXd gradient            = mine(iterate.gradient);
    const qp::ActiveSetStatistics inner = solver.solve(
      lambda, gradient, scaling, tolerance, max_inner_multiplications);
    statistics_.conjugate_gradient_steps += inner.conjugate_gradient_steps;
    statistics_.expansion_steps += inner.expansion_steps;
    statistics_.release_steps += inner.release_steps;

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
