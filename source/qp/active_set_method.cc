#include <stiction/qp/active_set_method.h>
#include <stiction/qp/feasible_set.h>
#include <stiction/qp/symmetric_operator.h>

#include <cmath>
#include <limits>

namespace stiction::qp
{
  ActiveSetMethod::ActiveSetMethod(const SymmetricOperator &A,
                                   const FeasibleSet &set,
                                   const double norm)
    : A_(A)
    , set_(set)
    , fixed_step_(1.9 / norm)
  {
    eigen_assert(A.size() == set.size());
  }



  ActiveSetStatistics
  ActiveSetMethod::solve(Eigen::VectorXd &x,
                         Eigen::VectorXd &gradient,
                         const Scaling &scaling,
                         const double tolerance,
                         const unsigned int max_multiplications)
  {
    eigen_assert(x.size() == A_.size() && gradient.size() == A_.size());
    const unsigned long multiplications_before = A_.n_multiplications();
    ActiveSetStatistics statistics;

    x_        = x;
    gradient_ = gradient;
    split();
    p_ = free_;
    start();

    // A step that changed nothing is followed by a release; if that changes
    // nothing either, rounding is all that is left.
    bool idle = false;
    while (true)
      {
        statistics.multiplications = static_cast<unsigned int>(
          A_.n_multiplications() - multiplications_before);
        statistics.residual  = set_.natural_residual(x_, gradient_, scaling);
        statistics.converged = statistics.residual <= tolerance;
        if (statistics.converged || std::isnan(statistics.residual) ||
            statistics.multiplications >= max_multiplications)
          break;

        const Eigen::VectorXd before = x_;
        if (idle || must_release(scaling, tolerance))
          {
            release();
            split();
            p_ = free_;
            ++statistics.release_steps;
            if (x_ == before && idle)
              break;
            idle = x_ == before;
            continue;
          }

        A_.vmult(Ap_, p_);
        const double curvature = p_.dot(Ap_);
        if (!(curvature > 0.)) // nothing is free
          {
            idle = true;
            continue;
          }
        const double alpha_cg       = gradient_.dot(p_) / curvature;
        const double alpha_feasible = set_.largest_feasible_step(x_, -p_);
        if (alpha_cg <= alpha_feasible)
          {
            x_ -= alpha_cg * p_;
            gradient_ -= alpha_cg * Ap_;
            set_.project(x_); // removes rounding only
            split();
            p_ = free_ - free_.dot(Ap_) / curvature * p_;
            ++statistics.conjugate_gradient_steps;
          }
        else
          {
            expand(alpha_cg, alpha_feasible);
            split();
            p_ = free_;
            ++statistics.expansion_steps;
          }
        idle = x_ == before;
      }

    x        = x_;
    gradient = gradient_;
    return statistics;
  }



  void
  ActiveSetMethod::expand(const double alpha_cg, const double alpha_feasible)
  {
    if (guarded_projected_step(alpha_cg, p_))
      return;
    go_to_boundary(alpha_feasible);
    split();
    projected_step(fixed_step_, free_);
  }



  void
  ActiveSetMethod::go_to_boundary(const double alpha_feasible)
  {
    x_ -= alpha_feasible * p_;
    gradient_ -= alpha_feasible * Ap_;
    set_.project(x_); // removes rounding only
  }



  Eigen::VectorXd
  ActiveSetMethod::step_to_projection(const double step,
                                      const Eigen::VectorXd &direction) const
  {
    Eigen::VectorXd target = x_ - step * direction;
    set_.project(target);
    return target - x_;
  }



  void
  ActiveSetMethod::projected_step(const double step,
                                  const Eigen::VectorXd &direction)
  {
    const Eigen::VectorXd d = step_to_projection(step, direction);
    Eigen::VectorXd Ad;
    A_.vmult(Ad, d);
    x_ += d;
    gradient_ += Ad;
  }



  bool
  ActiveSetMethod::guarded_projected_step(const double step,
                                          const Eigen::VectorXd &direction)
  {
    const Eigen::VectorXd d = step_to_projection(step, direction);
    if (d.isZero(0.))
      return false;
    Eigen::VectorXd Ad;
    A_.vmult(Ad, d);
    // Near the solution the change drowns in the rounding of dᵀr; a step that
    // raises the energy by no more than that is as good as one that lowers it.
    const double rounding = 4. * std::numeric_limits<double>::epsilon() *
                            x_.cwiseAbs().dot(gradient_.cwiseAbs());
    if (!(d.dot(gradient_) + 0.5 * d.dot(Ad) <= rounding))
      return false;
    x_ += d;
    gradient_ += Ad;
    return true;
  }



  void
  ActiveSetMethod::split()
  {
    set_.split(x_, gradient_, fixed_step_, free_, chopped_);
  }



  bool
  ActiveSetMethod::is_disproportionate(const double gamma) const
  {
    const Eigen::VectorXd reduced_free =
      -step_to_projection(fixed_step_, free_) / fixed_step_;
    return chopped_.squaredNorm() > gamma * gamma * reduced_free.dot(free_);
  }
} // namespace stiction::qp
