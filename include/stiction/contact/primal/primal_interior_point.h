#ifndef stiction_contact_primal_primal_interior_point_h
#define stiction_contact_primal_primal_interior_point_h

#include <stiction/contact/primal/contact_state.h>

#include <functional>

namespace stiction
{
  class ContactLevel;
  class NewtonSystem;

  /// An interior point method for contact with given or Coulomb friction in
  /// displacements: the safe way when Newton steps do not get closer.
  ///
  /// Contact forces λ and their duals, gaps and slips, are a point of
  /// qp::CentralPath. To first order the conditions of a node are D Δλ + Δ(gap, slip) =
  /// c, which is a spring D⁻¹ on it: each step is a linear elastic problem on
  /// springs at all contact nodes, with the solver of Newton's method. Nothing is
  /// sorted into open and closed, so that the stiffness of a body against bending,
  /// however far below that of its nodes, does not matter.
  ///
  /// Equilibrium with λ and the agreement of gaps with the displacement are reached
  /// along with μ → 0 (an infeasible path); a system is solved the better, the smaller
  /// μ is.
  class PrimalInteriorPoint
  {
  public:
    /// Told after each step how many Krylov iterations it took, and where it led.
    using Observer =
      std::function<void(unsigned int iterations, const ContactResidual &)>;

    /// @param system of this problem. All arguments must outlive the object.
    PrimalInteriorPoint(const ContactLevel &problem, NewtonSystem &system);

    /// Replaces the state by one whose residual is at most the tolerance, or by the best
    /// one found if that is better. Only the scales and the displacement are taken from
    /// it. Collective.
    void solve(ContactState &state, double tolerance, unsigned int max_steps,
               const Observer &observer);

  private:
    class Path;

    const ContactLevel &problem_;
    NewtonSystem &system_;
  };
} // namespace stiction

#endif
