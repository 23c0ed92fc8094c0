#pragma once

#include <stiction/qp/solvers/nystrom_preconditioner.h>
#include <stiction/qp/solvers/solver_run.h>

#include <Eigen/Core>

#include <functional>

namespace stiction::qp
{
  class SlipBound;
  class SymmetricOperator;
  struct Scaling;

  /// Contact with friction by an inexact semismooth Newton method on the dual
  /// problem, in the form of Alart and Curnier: with given friction the
  /// quadratic program over half-lines times discs, with Coulomb friction the
  /// problem itself, without an outer loop.
  ///
  /// A step looks at a = x − ρr to tell which nodes are closed and which of
  /// them slip. Open nodes are set to zero, a slipping one is moved onto its
  /// circle, and what is left free (normal forces of closed nodes, both
  /// tangential forces of sticking ones, and the force along the circle of
  /// slipping ones) follows from a linear system, in which a slipping node
  /// carries the curvature of its circle. The system is symmetric with given
  /// friction (conjugate gradients) and has the extra column of dg = F dλ_ν
  /// with Coulomb friction (GMRES). It is solved loosely; every iteration
  /// costs one product with the operator, and every product improves the
  /// preconditioner of the steps that follow.
  ///
  /// The solution does not depend on ρ_i = c/(mean diagonal entry of Q_ii),
  /// the path does: too large a c makes the iteration cycle. It is divided by
  /// three whenever the residual has not fallen over three steps. No proof of
  /// global convergence is known: a run that stands still says so, and the
  /// caller needs a method with a proof to fall back on.
  class SemismoothNewton
  {
  public:
    /// Called after each step with its number and the natural residual.
    using Observer = std::function<void(unsigned int step, double residual)>;

    /// @param Q the operator, of size 3m, or its tangential block, of size 2m,
    ///   for the problem on discs alone; must outlive the object.
    /// @param nodal_compliance about tr(Q_ii)/3 at every node, length m, > 0.
    /// @param ends_feasible whether the result is moved into its feasible set,
    ///   which costs a product. Without it may be outside by less than the
    ///   tolerance: good enough inside of another iteration.
    SemismoothNewton(const SymmetricOperator &Q, Eigen::VectorXd nodal_compliance,
                     bool ends_feasible = true);

    /// Moves x until its natural residual is at most tolerance.
    ///
    /// @param x in: any point; out: the solution, or the feasible point with
    ///   the smallest residual seen if there is no progress, or x as it was if
    ///   none has a smaller one. Entries (ν; t1; t2) or (t1; t2).
    /// @param gradient in: Qx − h at the given x; out: at the returned one.
    SolverRun solve(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                    const SlipBound &slip_bound, const Scaling &scaling, double tolerance,
                    unsigned int max_steps, const Observer &observer);

    /// From now on linear systems are solved by LU factors instead of Krylov
    /// iterations: where Q is ill-conditioned.
    ///
    /// @param Q the operator as a matrix, must outlive the object.
    void solve_directly(const Eigen::MatrixXd &Q);

  private:
    /// One Newton step; returns its Krylov iterations.
    unsigned int step(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                      const Eigen::VectorXd &rho, const SlipBound &slip_bound,
                      double reduction);

    const SymmetricOperator &Q_;
    const Eigen::MatrixXd *matrix_ = nullptr; ///< for direct solves
    const Eigen::VectorXd nodal_compliance_;
    const bool ends_feasible_;
    double c_;                             ///< kept between runs
    NystromPreconditioner preconditioner_; ///< so is this
  };
} // namespace stiction::qp
