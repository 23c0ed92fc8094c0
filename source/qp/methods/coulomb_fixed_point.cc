#include <stiction/qp/methods/coulomb_fixed_point.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace stiction
{
  namespace
  {
    // The part of its first error to which an approximation is solved. Solved
    // further, it would only be nearer to a bound that is about to change.
    constexpr double approximation_reduction = 0.3;

    // Approximations without a new smallest residual before giving up.
    constexpr unsigned int max_idle_steps = 30;

    // The contraction is averaged over so many approximations.
    constexpr std::size_t contraction_horizon = 5;
  } // namespace

  CoulombFixedPoint::CoulombFixedPoint(std::unique_ptr<DualMethod> given_friction)
    : given_friction_(std::move(given_friction))
  {
  }

  DualMethodStatistics CoulombFixedPoint::statistics() const
  {
    DualMethodStatistics all = given_friction_->statistics();
    all.coulomb_iterations   = iterations_;
    all.contraction          = contraction_;
    return all;
  }

  DualMethodResult CoulombFixedPoint::solve(DualIterate &iterate, const Task &task)
  {
    const StoppingRule &rule = task.rule;
    DualMethodResult result;
    result.residual = task.residual(iterate);
    result.change   = std::numeric_limits<double>::infinity();
    if (result.residual <= rule.residual)
      result.change = 0.; // nothing to do

    std::deque<double> residuals = {result.residual};
    double smallest              = result.residual;
    unsigned int idle_steps      = 0;
    while (true)
      {
        result.converged =
          result.residual <= rule.residual && result.change <= rule.change;
        if (result.converged || result.stagnated ||
            result.iterations >= rule.max_iterations)
          break;

        const Eigen::VectorXd before = iterate.lambda;
        const StoppingRule inner{
          std::max(approximation_reduction * result.residual, 0.5 * rule.residual),
          std::numeric_limits<double>::infinity(),
          rule.max_iterations - result.iterations};
        const DualMethodResult approximation = given_friction_->solve(
          iterate,
          {qp::SlipBound::given(task.slip_bound.at(before)), task.scaling, inner});
        result.iterations += approximation.iterations;
        ++iterations_;

        result.change   = relative_change(iterate.lambda, before);
        result.residual = task.residual(iterate);
        task.observer({approximation.iterations, result.residual, result.change});

        residuals.push_back(result.residual);
        if (residuals.size() > contraction_horizon + 1)
          residuals.pop_front();
        contraction_ = std::pow(result.residual / residuals.front(),
                                1. / static_cast<double>(residuals.size() - 1));

        idle_steps = result.residual < 0.9 * smallest ? 0 : idle_steps + 1;
        smallest   = std::min(smallest, result.residual);
        if (result.residual <= rule.residual && result.change <= rule.change)
          continue; // converged
        if ((approximation.iterations == 0 && result.change == 0.) ||
            approximation.stagnated || !std::isfinite(result.residual))
          {
            result.stagnated = true;
            result.reason    = approximation.reason;
          }
        else if (idle_steps >= max_idle_steps)
          {
            result.stagnated = true;
            result.reason    = "the successive approximations of Coulomb "
                               "friction do not contract";
          }
      }
    return result;
  }
} // namespace stiction
