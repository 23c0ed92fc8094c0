#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/active_set_method.h>

#include <cassert>
#include <cmath>
#include <limits>

namespace stiction::qp
{
  namespace
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();

    // Without a new smallest residual in so many products, steps move the last
    // digits to and fro.
    constexpr unsigned int max_idle_multiplications = 2000;

    // Asserts that a step does not raise the energy. Empty without assertions.
#ifdef NDEBUG
    class EnergyWatch
    {
    public:
      void before_step(const Eigen::VectorXd &, const Eigen::VectorXd &) {}

      void after_step(const Eigen::VectorXd &, const Eigen::VectorXd &, double) const {}
    };
#else
    class EnergyWatch
    {
    public:
      void before_step(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient)
      {
        x_        = x;
        gradient_ = gradient;
      }

      // A quadratic function changes by ½ dᵀ(r_old + r_new) along d. A NaN
      // passes: solve() ends with it, in its residual.
      void after_step(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                      const double norm) const
      {
        const Eigen::VectorXd d = x - x_;
        const double change     = 0.5 * d.dot(gradient_ + gradient);
        // the rounding of x, of the sum above and of the product with A
        const double rounding = 16. * epsilon *
                                ((x_.cwiseAbs() + x.cwiseAbs())
                                   .dot(gradient_.cwiseAbs() + gradient.cwiseAbs()) +
                                 static_cast<double>(x.size()) * norm * d.squaredNorm());
        assert(!(change > rounding) && "a step raised the dual energy");
        (void)change;
        (void)rounding;
      }

    private:
      Eigen::VectorXd x_, gradient_;
    };
#endif
  } // namespace

  ActiveSetMethod::ActiveSetMethod(const SymmetricOperator &A, const FeasibleSet &set,
                                   const double norm)
    : A_(A)
    , set_(set)
    , fixed_step_(1.9 / norm)
  {
    eigen_assert(A.size() == set.size());
  }

  SolverRun ActiveSetMethod::solve(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                                   const Scaling &scaling, const double tolerance,
                                   const unsigned int max_multiplications)
  {
    eigen_assert(x.size() == A_.size() && gradient.size() == A_.size());
    const unsigned long multiplications_before = A_.n_multiplications();
    SolverRun statistics;

    x_        = x;
    gradient_ = gradient;
    split();
    p_             = free_;
    spectral_step_ = {};

    // A step that changed nothing is followed by a release; if that changes
    // nothing either, rounding is all that is left.
    bool idle = false;
    EnergyWatch energy;
    double smallest          = std::numeric_limits<double>::infinity();
    unsigned int at_smallest = 0;
    while (true)
      {
        statistics.multiplications =
          static_cast<unsigned int>(A_.n_multiplications() - multiplications_before);
        statistics.residual  = set_.natural_residual(x_, gradient_, scaling);
        statistics.converged = statistics.residual <= tolerance;
        if (observer_)
          observer_(statistics.multiplications, x_, statistics.residual);
        if (statistics.residual < 0.99 * smallest)
          {
            smallest    = statistics.residual;
            at_smallest = statistics.multiplications;
          }
        if (statistics.converged || std::isnan(statistics.residual) ||
            statistics.multiplications >= max_multiplications ||
            statistics.multiplications > at_smallest + max_idle_multiplications)
          break;

        const Eigen::VectorXd before = x_;
        energy.before_step(x_, gradient_);
        if (idle || must_release(scaling, tolerance))
          {
            release();
            energy.after_step(x_, gradient_, 1.9 / fixed_step_);
            split();
            p_ = free_;
            ++statistics.release_steps;
            if (x_ == before && idle)
              break;
            idle = x_ == before;
            continue;
          }

        improve(statistics);
        energy.after_step(x_, gradient_, 1.9 / fixed_step_);
        idle = x_ == before;
      }

    x        = x_;
    gradient = gradient_;
    return statistics;
  }

  void ActiveSetMethod::improve(SolverRun &statistics)
  {
    A_.vmult(Ap_, p_);
    const double curvature      = p_.dot(Ap_);
    const double slope          = gradient_.dot(p_);
    const double alpha_feasible = set_.largest_feasible_step(x_, -p_);
    const double alpha_cg       = slope / curvature;
    if (!(curvature > 0.))
      {
        // Nothing is free, or A is singular and the energy falls along −p
        // up to the boundary.
        if (slope > 0. && std::isfinite(alpha_feasible))
          {
            go_to_boundary(alpha_feasible);
            split();
            p_ = free_;
            ++statistics.expansion_steps;
          }
      }
    else if (alpha_cg <= alpha_feasible)
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
  }

  void ActiveSetMethod::expand(const double alpha_cg, const double alpha_feasible)
  {
    if (!guarded_projected_step(alpha_cg, p_))
      standard_expansion(alpha_feasible);
  }

  void ActiveSetMethod::standard_expansion(const double alpha_feasible)
  {
    go_to_boundary(alpha_feasible);
    split();
    fixed_projected_step(free_);
  }

  void ActiveSetMethod::go_to_boundary(const double alpha_feasible)
  {
    x_ -= alpha_feasible * p_;
    gradient_ -= alpha_feasible * Ap_;
    set_.project(x_); // removes rounding only
  }

  Eigen::VectorXd ActiveSetMethod::step_to_projection(
    const double step, const Eigen::VectorXd &direction) const
  {
    Eigen::VectorXd target = x_ - step * direction;
    set_.project(target);
    return target - x_;
  }

  void ActiveSetMethod::fixed_projected_step(const Eigen::VectorXd &direction)
  {
    Eigen::VectorXd d, Ad;
    while (true)
      {
        d = step_to_projection(fixed_step_, direction);
        A_.vmult(Ad, d);
        // The energy falls if the step is below 2/quotient. The norm was but
        // an estimate, and the quotient is at most the true one.
        const double square   = d.squaredNorm();
        const double quotient = d.dot(Ad) / square;
        if (!(square > 0. && fixed_step_ * quotient >= 2.))
          break;
        fixed_step_ = 1.9 / (1.1 * quotient);
      }
    x_ += d;
    gradient_ += Ad;
  }

  bool ActiveSetMethod::guarded_projected_step(const double step,
                                               const Eigen::VectorXd &direction)
  {
    const Eigen::VectorXd d = step_to_projection(step, direction);
    if (d.isZero(0.))
      return false;
    Eigen::VectorXd Ad;
    A_.vmult(Ad, d);
    // Near the solution the change drowns in the rounding of dᵀr; a step that
    // raises the energy by no more than that is as good as one that lowers it.
    const double rounding = 4. * epsilon * x_.cwiseAbs().dot(gradient_.cwiseAbs());
    if (!(d.dot(gradient_) + 0.5 * d.dot(Ad) <= rounding))
      return false;
    x_ += d;
    gradient_ += Ad;
    return true;
  }

  bool ActiveSetMethod::spectral_release()
  {
    return guarded_projected_step(spectral_step_.next(x_, gradient_, fixed_step_),
                                  gradient_);
  }

  void ActiveSetMethod::split()
  {
    set_.split(x_, gradient_, fixed_step_, free_, chopped_);
  }

  bool ActiveSetMethod::is_disproportionate(const double gamma) const
  {
    const Eigen::VectorXd reduced_free =
      -step_to_projection(fixed_step_, free_) / fixed_step_;
    return chopped_.squaredNorm() > gamma * gamma * reduced_free.dot(free_);
  }
} // namespace stiction::qp
