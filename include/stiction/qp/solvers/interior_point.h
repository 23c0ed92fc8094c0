#pragma once

#include <stiction/qp/solvers/solver_run.h>

#include <Eigen/Core>

#include <functional>

namespace stiction::qp
{
  class SlipBound;
  struct Scaling;

  /// A primal-dual interior point method for contact with given or Coulomb
  /// friction, for operators that are known as a matrix.
  ///
  /// At every node the forces (λ_ν; g_i, λ_t) and their duals (w_ν; σ, w_t),
  /// the gap and the slip with a bound σ on its length, stay inside the half
  /// line times the second-order cone; a Newton step goes for
  /// λ_ν w_ν = μ, (g, λ_t)∘(σ, w_t) = (μ, 0) in the Jordan algebra of the cone,
  /// and μ falls as fast as Mehrotra's predictor finds possible (S. Mehrotra,
  /// SIAM J. Optim. 2, 1992; F. Alizadeh and D. Goldfarb, Math. Program. 95,
  /// 2003). With Coulomb friction g follows λ_ν in every step.
  ///
  /// Nothing in it depends on how well Q is conditioned, there is no number to
  /// choose, and 10 to 30 steps lead from anywhere to the solution. Each costs
  /// the LU factors of a matrix of size 3m: it serves where products alone do
  /// not lead to an answer.
  class InteriorPoint
  {
  public:
    /// Called after each step with its number and the natural residual.
    using Observer = std::function<void(unsigned int step, double residual)>;

    /// @param Q symmetric positive definite, 3m × 3m, must outlive the object.
    explicit InteriorPoint(const Eigen::MatrixXd &Q);

    /// Replaces x by a point whose natural residual is at most tolerance, or by
    /// the best one found if rounding ends the progress before.
    ///
    /// @param x entries (ν; t1; t2).
    /// @param gradient in: Qx − h at the given x; out: at the returned one.
    SolverRun solve(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                    const SlipBound &slip_bound, const Scaling &scaling, double tolerance,
                    unsigned int max_steps, const Observer &observer) const;

  private:
    class Path;

    const Eigen::MatrixXd &Q_;
  };
} // namespace stiction::qp
