#pragma once

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;
  class StiffnessSolver;

  /// The duality gap, relative: √(2 gap)/‖û‖_K, the gap being a bound on
  /// ½‖û − u*‖²_K for the displacement
  /// û, u with its contact components moved by one nodal prox step:
  /// gap = λ̂_νᵀ(d − Nû) + Σ(g‖û_t‖ − λ̂_t·û_t) + ½ sᵀK⁻¹s,
  /// s = f − Bᵀλ̂ − Kû, for any feasible λ̂.
  ///
  /// Taken is the λ̂ at which the prox step ends. It is within the error of
  /// λ and makes the first two terms vanish identically, so that nothing is
  /// subtracted and the bound shrinks with the error itself; with P(λ) in
  /// its place it would shrink with the root of it wherever the slip bound
  /// has moved since λ was computed. The solver is asked for one solve with
  /// what u lacks to be in equilibrium with λ̂. Collective.
  ///
  /// @param solver accurate to some digits.
  ///
  /// Throws std::runtime_error if the solver does.
  double duality_gap(const LinearElasticity &elasticity, const ContactSurface &surface,
                     const State &state, StiffnessSolver &solver);
} // namespace stiction
