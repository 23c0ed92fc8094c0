#include <stiction/contact/gauss_seidel.h>
#include <stiction/qp/disc_active_set.h>
#include <stiction/qp/proportioning.h>
#include <stiction/qp/spectral_norm.h>

#include <algorithm>
#include <limits>

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

    void
    accumulate(qp::ActiveSetStatistics &sum, const qp::ActiveSetStatistics &one)
    {
      sum.conjugate_gradient_steps += one.conjugate_gradient_steps;
      sum.expansion_steps += one.expansion_steps;
      sum.release_steps += one.release_steps;
      sum.multiplications += one.multiplications;
      sum.residual  = one.residual;
      sum.converged = one.converged;
    }
  } // namespace



  GaussSeidel::GaussSeidel(const SchurComplement &schur)
    : schur_(schur)
    , normal_block_(schur, DualBlock::normal)
    , tangential_block_(schur, DualBlock::tangential)
    , normal_norm_(qp::spectral_norm(normal_block_))
    , tangential_norm_(qp::spectral_norm(tangential_block_))
  {
  }



  GivenFrictionResult
  GaussSeidel::solve(DualIterate &iterate,
                     const Eigen::VectorXd &slip_bound,
                     const qp::Scaling &scaling,
                     const StoppingRule &rule,
                     const Observer &observer)
  {
    const qp::HalfLinesTimesDiscs feasible_set(slip_bound);
    const auto residual = [&]() {
      return feasible_set.natural_residual(
        iterate.lambda, iterate.gradient, scaling);
    };

    GivenFrictionResult result;
    make_feasible(iterate, slip_bound);
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
        tangential_half_sweep(iterate, slip_bound, scaling, tolerance);

        ++result.iterations;
        result.residual   = residual();
        const double norm = iterate.lambda.norm();
        result.change =
          norm > 0. ? (iterate.lambda - before).norm() / norm : 0.;
        observer(result.iterations, result.residual, result.change);

        result.converged =
          result.residual <= rule.residual && result.change <= rule.change;
        idle_sweeps = result.residual < 0.9 * smallest ? 0 : idle_sweeps + 1;
        smallest    = std::min(smallest, result.residual);
        result.stagnated =
          !result.converged &&
          (idle_sweeps >= max_idle_sweeps || !(result.residual < 1e300));
      }
    return result;
  }



  void
  GaussSeidel::make_feasible(DualIterate &iterate,
                             const Eigen::VectorXd &slip_bound) const
  {
    const Eigen::Index m      = schur_.n_nodes();
    Eigen::VectorXd projected = iterate.lambda;
    qp::HalfLinesTimesDiscs(slip_bound).project(projected);
    const Eigen::VectorXd d = projected - iterate.lambda;

    Eigen::VectorXd Qd;
    for (const DualBlock block : {DualBlock::normal, DualBlock::tangential})
      {
        const Eigen::VectorXd part =
          block == DualBlock::normal ? d.head(m) : d.tail(2 * m);
        if (part.isZero(0.))
          continue;
        schur_.vmult(DualBlock::all, block, Qd, part);
        iterate.gradient += Qd;
      }
    iterate.lambda = projected;
  }



  void
  GaussSeidel::normal_half_sweep(DualIterate &iterate,
                                 const qp::Scaling &scaling,
                                 const double tolerance)
  {
    const Eigen::Index m     = schur_.n_nodes();
    Eigen::VectorXd lambda   = iterate.lambda.head(m);
    Eigen::VectorXd gradient = iterate.gradient.head(m);
    const qp::HalfLines half_lines(m);
    qp::Proportioning solver(normal_block_, half_lines, normal_norm_);
    accumulate(
      normal_statistics_,
      solver.solve(
        lambda, gradient, scaling, tolerance, max_inner_multiplications));

    const Eigen::VectorXd change = lambda - iterate.lambda.head(m);
    if (change.isZero(0.))
      return;
    Eigen::VectorXd coupling;
    schur_.vmult(DualBlock::tangential, DualBlock::normal, coupling, change);
    iterate.lambda.head(m)   = lambda;
    iterate.gradient.head(m) = gradient;
    iterate.gradient.tail(2 * m) += coupling;
  }



  void
  GaussSeidel::tangential_half_sweep(DualIterate &iterate,
                                     const Eigen::VectorXd &slip_bound,
                                     const qp::Scaling &scaling,
                                     const double tolerance)
  {
    const Eigen::Index m     = schur_.n_nodes();
    Eigen::VectorXd lambda   = iterate.lambda.tail(2 * m);
    Eigen::VectorXd gradient = iterate.gradient.tail(2 * m);
    const qp::Discs discs(slip_bound);
    qp::DiscActiveSet solver(tangential_block_, discs, tangential_norm_);
    accumulate(
      tangential_statistics_,
      solver.solve(
        lambda, gradient, scaling, tolerance, max_inner_multiplications));

    const Eigen::VectorXd change = lambda - iterate.lambda.tail(2 * m);
    if (change.isZero(0.))
      return;
    Eigen::VectorXd coupling;
    schur_.vmult(DualBlock::normal, DualBlock::tangential, coupling, change);
    iterate.lambda.tail(2 * m)   = lambda;
    iterate.gradient.tail(2 * m) = gradient;
    iterate.gradient.head(m) += coupling;
  }
} // namespace stiction
