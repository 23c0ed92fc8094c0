#include <stiction/qp/methods/admm.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stiction
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

  Admm::Admm(const DualOperator &Q)
    : matrix_(Q.matrix())
    , Q_(Q.diagonal_block(DualBlock::all))
    , pull_(Q.nodal_compliance().replicate(3, 1))
  {
    if (matrix_ == nullptr)
      throw std::invalid_argument("this method needs Q as a matrix");
  }

  void Admm::factorize(const double factor)
  {
    factor_                     = factor;
    Eigen::MatrixXd regularized = *matrix_;
    regularized.diagonal() += factor * pull_;
    cholesky_.compute(regularized);
    ++statistics_.dense_factorizations;
  }

  DualMethodResult Admm::solve(DualIterate &iterate, const Task &task)
  {
    Eigen::VectorXd &x = iterate.lambda, &gradient = iterate.gradient;
    const StoppingRule &rule = task.rule;
    if (statistics_.dense_factorizations == 0)
      factorize(first_factor);

    // h = Qx − r
    Eigen::VectorXd h;
    Q_.vmult(h, x);
    h -= gradient;

    // Where it was left: at a solution D u = −r.
    Eigen::VectorXd z = x, before = x;
    qp::project(z, task.slip_bound);
    Eigen::VectorXd u = -gradient.cwiseQuotient(factor_ * pull_);

    unsigned int wait = first_wait, waited = 0;
    DualMethodResult result;
    result.residual = task.residual(iterate);
    while (true)
      {
        if (result.residual <= rule.residual)
          {
            // x is feasible up to the tolerance only
            qp::make_feasible(x, gradient, Q_, task.slip_bound);
            result.residual  = task.residual(iterate);
            result.converged = result.residual <= rule.residual;
          }
        if (result.converged || result.iterations >= rule.max_iterations ||
            !std::isfinite(result.residual))
          break;

        const Eigen::VectorXd D = factor_ * pull_;
        x                       = cholesky_.solve(h + D.cwiseProduct(z - u));
        gradient                = D.cwiseProduct(z - u - x); // = Qx − h

        const Eigen::VectorXd relaxed  = relaxation * x + (1. - relaxation) * z;
        const Eigen::VectorXd z_before = z;
        z                              = relaxed + u;
        qp::project(z, task.slip_bound);
        u += relaxed - z;
        ++result.iterations;
        ++statistics_.admm_iterations;

        result.residual = task.residual(iterate);
        result.change   = relative_change(x, before);
        before          = x;
        task.observer({1, result.residual, result.change});

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
    if (!result.converged && z.allFinite())
      {
        x = z;
        Q_.vmult(gradient, x);
        gradient -= h;
        result.residual = task.residual(iterate);
      }
    return result;
  }
} // namespace stiction
