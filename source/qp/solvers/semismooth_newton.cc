#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/contact_linearization.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/krylov_methods.h>
#include <stiction/qp/solvers/semismooth_newton.h>

#include <Eigen/Dense>

#include <cmath>
#include <deque>
#include <utility>

namespace stiction::qp
{
  namespace
  {
    // ρ = c/compliance. With a larger one the number of steps grows under
    // refinement, until the iteration cycles.
    constexpr double first_c = 0.1;

    // c is reduced if the residual falls by less than this in three steps.
    constexpr double required_fall     = 0.7;
    constexpr std::size_t fall_horizon = 3;

    // The part of its right-hand side to which a linear system is solved.
    // Solved further, it would only follow a contact set that is about to
    // change.
    constexpr double first_reduction = 0.1;

    constexpr unsigned int max_krylov_iterations = 200;

    // Steps without a new smallest residual before giving up.
    constexpr unsigned int max_idle_steps = 15;

    // A point that is good enough has to be so in the feasible set, too; after
    // so many that were not there is no hope.
    constexpr unsigned int max_ends = 5;

    // Where an iteration was.
    struct Point
    {
      Eigen::VectorXd x, gradient;
      double residual;
    };

    // d = d0 + Z y by LU factors of the reduced matrix.
    Eigen::VectorXd direct_step(const ContactLinearization &conditions,
                                const Eigen::VectorXd &gradient, const Eigen::MatrixXd &Q)
    {
      const Eigen::Index n = conditions.n_free();
      Eigen::MatrixXd A(n, n);
      for (Eigen::Index k = 0; k < n; ++k)
        {
          const Eigen::VectorXd z = conditions.embed(Eigen::VectorXd::Unit(n, k));
          Eigen::VectorXd Qz      = Eigen::VectorXd::Zero(z.size());
          for (Eigen::Index j = 0; j < z.size(); ++j)
            if (z(j) != 0.)
              Qz += z(j) * Q.col(j);
          A.col(k) = conditions.test(Qz);
        }
      A.diagonal() += conditions.curvature();
      const Eigen::VectorXd unit = A.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
      A                          = unit.asDiagonal() * A * unit.asDiagonal();
      const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> factors(A);

      const Eigen::VectorXd &d0             = conditions.prescribed();
      const Eigen::VectorXd right_hand_side = -conditions.test(gradient + Q * d0);
      const Eigen::VectorXd y =
        unit.cwiseProduct(factors.solve(unit.cwiseProduct(right_hand_side)));
      return d0 + conditions.embed(y);
    }
  } // namespace

  SemismoothNewton::SemismoothNewton(const SymmetricOperator &Q,
                                     Eigen::VectorXd nodal_compliance,
                                     const bool ends_feasible)
    : Q_(Q)
    , nodal_compliance_(std::move(nodal_compliance))
    , ends_feasible_(ends_feasible)
    , c_(first_c)
  {
    eigen_assert(Q.size() == 3 * nodal_compliance_.size() ||
                 Q.size() == 2 * nodal_compliance_.size());
  }

  SolverRun SemismoothNewton::solve(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                                    const SlipBound &slip_bound, const Scaling &scaling,
                                    const double tolerance, const unsigned int max_steps,
                                    const Observer &observer)
  {
    const auto residual_of_x = [&]() {
      return natural_residual(x, gradient, slip_bound, scaling);
    };
    SolverRun statistics;
    double reduction = first_reduction;
    std::deque<double> history;
    statistics.residual = residual_of_x();
    const Point first{x, gradient, statistics.residual};
    Point best              = first;
    unsigned int idle_steps = 0, n_ends = 0;
    while (true)
      {
        if (statistics.residual <= tolerance)
          {
            // up to here x was feasible up to the tolerance only
            if (ends_feasible_)
              make_feasible(x, gradient, Q_, slip_bound);
            statistics.residual  = residual_of_x();
            statistics.converged = statistics.residual <= tolerance;
            if (statistics.converged)
              break;
            // where Q is ill-conditioned, this step alone may be too large
            statistics.stagnated = ++n_ends > max_ends;
            reduction /= 3.;
          }
        if (statistics.newton_steps >= max_steps || statistics.stagnated)
          break;

        const Eigen::VectorXd rho = c_ * nodal_compliance_.cwiseInverse();
        statistics.krylov_iterations += step(x, gradient, rho, slip_bound, reduction);
        ++statistics.newton_steps;

        statistics.residual = residual_of_x();
        observer(statistics.newton_steps, statistics.residual);

        if (!std::isfinite(statistics.residual))
          {
            statistics.stagnated = true;
            break;
          }

        history.push_back(ContactLinearization(x, gradient, rho, slip_bound).residual() /
                          c_);
        if (history.size() > fall_horizon &&
            history.back() > required_fall * history[history.size() - 1 - fall_horizon])
          {
            c_ /= 3.;
            history.clear();
          }

        idle_steps = statistics.residual < 0.9 * best.residual ? 0 : idle_steps + 1;
        if (statistics.residual < best.residual)
          best = {x, gradient, statistics.residual};
        statistics.stagnated = idle_steps >= max_idle_steps;
      }
    if (!statistics.converged)
      {
        x        = best.x;
        gradient = best.gradient;
        make_feasible(x, gradient, Q_, slip_bound);
        statistics.residual = residual_of_x();
        if (statistics.residual > first.residual)
          {
            // where Q is ill-conditioned, the small step to the feasible set
            // may have changed the gradient much
            x                   = first.x;
            gradient            = first.gradient;
            statistics.residual = first.residual;
          }
      }
    return statistics;
  }

  void SemismoothNewton::solve_directly(const Eigen::MatrixXd &Q)
  {
    eigen_assert(Q.rows() == Q_.size());
    matrix_ = &Q;
    c_      = first_c;
  }

  unsigned int SemismoothNewton::step(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                                      const Eigen::VectorXd &rho,
                                      const SlipBound &slip_bound, const double reduction)
  {
    const ContactLinearization conditions(x, gradient, rho, slip_bound);
    if (matrix_ != nullptr)
      {
        const Eigen::VectorXd d = direct_step(conditions, gradient, *matrix_);
        x += d;
        gradient += *matrix_ * d;
        return 0;
      }

    const Eigen::VectorXd &d0 = conditions.prescribed();
    Eigen::VectorXd Qd;
    if (!d0.isZero(0.))
      {
        Q_.vmult(Qd, d0);
        preconditioner_.add(d0, Qd);
      }
    else
      Qd.setZero(x.size());

    preconditioner_.set_up(conditions, nodal_compliance_);
    const auto product = [&](const Eigen::VectorXd &v, Eigen::VectorXd &Av,
                             Eigen::VectorXd &image) {
      const Eigen::VectorXd d = conditions.embed(v);
      Q_.vmult(image, d);
      Av = conditions.test(image) + conditions.curvature().cwiseProduct(v);
      preconditioner_.add(d, image); // for the steps to come
    };
    const auto solve_linear       = slip_bound.is_coulomb() ? gmres : conjugate_gradients;
    const KrylovSolution solution = solve_linear(
      product, -conditions.test(gradient + Qd),
      [&](const Eigen::VectorXd &v) { return preconditioner_.apply(v); }, reduction,
      max_krylov_iterations);
    x += d0 + conditions.embed(solution.y);
    gradient += Qd;
    if (solution.image.size() > 0)
      gradient += solution.image;
    return solution.iterations;
  }
} // namespace stiction::qp
