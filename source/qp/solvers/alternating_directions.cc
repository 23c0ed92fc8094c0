#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/alternating_directions.h>

#include <algorithm>
#include <cmath>

namespace stiction::qp
{
  namespace
  {
    constexpr double relaxation = 1.7;

    // Ten fits the reference brick at every level from the first iteration on.
    constexpr double first_factor = 10.;

    // The factor is looked at after so many iterations, and changed when the
    // two residuals differ by more than this. Each change doubles the wait for
    // the next, because it costs a factorisation.
    constexpr unsigned int first_wait     = 10;
    constexpr double adaptation_threshold = 2.;

    // How much further x and z are apart than z moves. Relative, in the norms of
    // energies. Displacements are measured by Qx, how far the forces bend the body,
    // where the gradient is larger: it has the slip in it, which of a body that is
    // drawn along may be any distance and says nothing of the forces.
    double ratio_of_residuals(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                              const Eigen::VectorXd &h, const Eigen::VectorXd &z,
                              const Eigen::VectorXd &z_before, const Eigen::VectorXd &D)
    {
      const Eigen::VectorXd root = D.cwiseSqrt();
      const double displacement  = std::min(gradient.cwiseQuotient(root).norm(),
                                            (gradient + h).cwiseQuotient(root).norm());
      return root.cwiseProduct(x - z).norm() / root.cwiseProduct(x).norm() *
             displacement / root.cwiseProduct(z - z_before).norm();
    }
  } // namespace

  AlternatingDirections::AlternatingDirections(const Eigen::MatrixXd &matrix,
                                               const SymmetricOperator &Q,
                                               const Eigen::VectorXd &nodal_compliance)
    : matrix_(matrix)
    , Q_(Q)
    , pull_(nodal_compliance.replicate(3, 1))
  {
  }

  void AlternatingDirections::factorize(const double factor)
  {
    factor_                     = factor;
    Eigen::MatrixXd regularized = matrix_;
    regularized.diagonal() += factor * pull_;
    cholesky_.compute(regularized);
    ++n_factorizations_;
  }

  SolverRun AlternatingDirections::solve(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                                         const SlipBound &slip_bound,
                                         const Scaling &scaling, const double tolerance,
                                         const unsigned int max_iterations,
                                         const Observer &observer)
  {
    const unsigned int factorizations_before = n_factorizations_;
    const auto residual_of_x                 = [&]() {
      return natural_residual(x, gradient, slip_bound, scaling);
    };

    SolverRun statistics;
    if (n_factorizations_ == 0)
      factorize(first_factor);

    // h = Qx − r
    Eigen::VectorXd h;
    Q_.vmult(h, x);
    h -= gradient;

    // Where it was left: at a solution D u = −r.
    Eigen::VectorXd z = x;
    project(z, slip_bound);
    Eigen::VectorXd u = -gradient.cwiseQuotient(factor_ * pull_);

    unsigned int wait = first_wait, waited = 0;
    statistics.residual = residual_of_x();
    while (true)
      {
        if (statistics.residual <= tolerance)
          {
            // x is feasible up to the tolerance only
            make_feasible(x, gradient, Q_, slip_bound);
            statistics.residual  = residual_of_x();
            statistics.converged = statistics.residual <= tolerance;
          }
        if (statistics.converged || statistics.admm_iterations >= max_iterations ||
            !std::isfinite(statistics.residual))
          break;

        const Eigen::VectorXd D = factor_ * pull_;
        x                       = cholesky_.solve(h + D.cwiseProduct(z - u));
        gradient                = D.cwiseProduct(z - u - x); // = Qx − h

        const Eigen::VectorXd relaxed  = relaxation * x + (1. - relaxation) * z;
        const Eigen::VectorXd z_before = z;
        z                              = relaxed + u;
        project(z, slip_bound);
        u += relaxed - z;
        ++statistics.admm_iterations;

        statistics.residual = residual_of_x();
        observer(statistics.residual);

        if (++waited < wait)
          continue;
        const double ratio = ratio_of_residuals(x, gradient, h, z, z_before, D);
        if (std::isfinite(ratio) &&
            (ratio > adaptation_threshold || ratio < 1. / adaptation_threshold))
          {
            const double change = std::sqrt(ratio);
            factorize(factor_ * change);
            wait *= 2;
            waited = 0;
            u /= change;
          }
      }
    if (!statistics.converged && z.allFinite())
      {
        x = z;
        Q_.vmult(gradient, x);
        gradient -= h;
        statistics.residual = residual_of_x();
      }
    statistics.dense_factorizations = n_factorizations_ - factorizations_before;
    return statistics;
  }
} // namespace stiction::qp
