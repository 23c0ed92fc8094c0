#ifndef stiction_contact_primal_method_of_multipliers_h
#define stiction_contact_primal_method_of_multipliers_h

#include <stiction/contact/primal/contact_state.h>
#include <stiction/contact/primal/newton_system.h>
#include <stiction/contact/primal/primal_active_set.h>
#include <stiction/qp/solvers/solver_run.h>

#include <Eigen/Core>

namespace stiction
{
  class ContactLevel;

  /// Contact with given friction by the method of multipliers, with a proof of
  /// convergence from any start and for any ρ (R. T. Rockafellar, Augmented
  /// Lagrangians and applications of the proximal point algorithm in convex
  /// programming, 1976): the safe way when the Newton method does not get
  /// closer.
  ///
  /// With multipliers λ̄ held, the displacement minimises the convex,
  /// continuously differentiable energy ½uᵀKu − fᵀu + Σψ_i(w_i) − P·δ,
  /// ∇ψ_i = P(λ̄_i + ρ_i w_i) with P the projection on the half-line times the
  /// disc, by Newton steps with a line search; then λ̄ ← P(λ̄ + ρw).
  class MethodOfMultipliers
  {
  public:
    /// @param system of this problem. All arguments must outlive the object.
    MethodOfMultipliers(const ContactLevel &problem, NewtonSystem &system);

    /// Improves the state until its residual as a problem with this slip bound
    /// is small enough. Collective.
    ///
    /// @param slip_bound g, N, length m, held fixed.
    /// @param tolerance for the figures of the certificate.
    qp::IterationCounts solve(ContactState &state, const Eigen::VectorXd &slip_bound,
                              double tolerance, unsigned int max_newton_steps);

  private:
    /// ∇ψ: the forces that the multipliers and the springs give at w.
    Eigen::VectorXd forces(const Eigen::VectorXd &w) const;

    /// The second derivative of ψ as springs at the nodes.
    PrimalActiveSet linearize(const Eigen::VectorXd &w) const;

    /// Moves the state back along the step just taken to where the energy is
    /// least. Returns false if the step was no descent.
    bool search(ContactState &state, const ContactState &before) const;

    const ContactLevel &problem_;
    NewtonSystem &system_;
    const Eigen::VectorXd rho_;
    Eigen::VectorXd multipliers_, slip_bound_;
  };
} // namespace stiction

#endif
