#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/types.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;

  /// Where the work goes in the steps of a history.
  ///
  /// The elastic energy E = ½uᵀKu is quadratic: from the end 0 of one step to the end
  /// 1 of the next, Δ being the difference, ΔE = ½(Ku₀ + Ku₁)·Δu without an error of
  /// any order. Both ends are in equilibrium, Ku = f + R − Bᵀλ with the loads f and
  /// the forces R of the supports at prescribed unknowns, hence
  ///
  ///     ΔE = W_loads + W_supports − ½(λ₀ + λ₁)·Δ(Bu),
  ///     W_loads = ½(f₀ + f₁)·Δu,   W_supports = ½(R₀ + R₁)·Δu.
  ///
  /// With r = e − Bu, e being the offset of the obstacles from the undeformed body
  /// (gaps and displacements, without what slip is counted from), −Δ(Bu) = Δr − Δe,
  /// where Δr_ν is the change of the gap and −Δr_t the slip of the step. Friction
  /// holds at the end of the step, where it dissipates D = λ₁ₜ·slip ≥ 0. So
  ///
  ///     W_loads + W_supports + W_obstacles = ΔE + D + X,
  ///     W_obstacles = −½(λ₀ + λ₁)·Δe,
  ///     X = ½(λ₀ − λ₁)ₜ·slip − ½(λ₀ + λ₁)_ν Δr_ν.
  ///
  /// X is what the length of the step leaves over: zero where slip or stick is steady,
  /// else it vanishes with the number of steps. Every term is computed from its own
  /// data, so that the balance is a check of displacement, forces and slip.
  ///
  /// The frames of contact nodes may turn from end to end: the terms are computed in
  /// Cartesian components, in which what the turning changes of the slip counts to X,
  /// and so does the work at nodes that are contact nodes at one end alone. Of obstacles
  /// that are displaced or pressed on, e counts their displacement and the way to them
  /// where they began, however they are linearised; of those that turn Δe counts the
  /// angle of the step, for λ₀ with the arms at its beginning, for λ₁ with those at its
  /// end.
  ///
  /// On a new mesh the interpolated u₀ is in no equilibrium, and near ν = 0.5 its
  /// internal forces are much too large. ΔE is then that of the energies, E₀ on the mesh
  /// before; the balance gives the work of supports that move, or else X, with the energy
  /// that the new mesh changes.
  ///
  /// The first step begins without displacement and forces, whatever the loads there:
  /// the energy that an initial interference gives to the body is in its X.
  class EnergyBalance
  {
  public:
    /// What happened in a step, J.
    struct Step
    {
      double loads = 0., supports = 0., obstacles = 0.; ///< work on the body
      double elastic_change = 0.;                       ///< ΔE
      double dissipation    = 0.;
      double time_stepping  = 0.; ///< X
      double elastic_energy = 0.; ///< E at its end
      /// What the balance lacks, relative to the largest term, or to 1e-6 E where all
      /// are smaller; nothing after a change of the mesh, where it gives a term.
      std::optional<double> error;

      /// Adds up terms and takes the other's energy. The error is that of no step.
      Step &operator+=(const Step &other);
    };

    /// Begins with the body as it is made.
    ///
    /// @param surface at the time of that, for the gaps.
    EnergyBalance(const LinearElasticity &elasticity, const ContactSurface &surface);

    /// Goes on from the end of a step. After a restart the elasticity may have other
    /// loads and supports; those until then follow from the balance of the forces there.
    ///
    /// @param surface at the time of that, for the gaps.
    /// @param energy_before on the mesh from which the state was carried, if it was, J.
    EnergyBalance(const LinearElasticity &elasticity, const ContactSurface &surface,
                  const State &state, std::optional<double> energy_before = {});

    /// E of the last end, on the mesh where that was solved, J.
    double elastic_energy() const { return elastic_energy_; }

    /// Takes the end of a step. Collective.
    ///
    /// @param surface on which slip is counted from the end of the step before.
    Step add_step(const LinearElasticity &elasticity, const ContactSurface &surface,
                  const State &state);

  private:
    /// Of a step. Vectors over contact nodes have Cartesian components, by blocks.
    struct End
    {
      LA::Vector u, internal_force, load, reaction;
      std::vector<dealii::types::global_dof_index> nodes; ///< by first unknowns
      Eigen::VectorXd force   = {};                       ///< Bᵀλ, on the obstacle
      Eigen::VectorXd offset  = {}; ///< e = U + way_at_start, not turned
      Eigen::VectorXd gap     = {}; ///< r_ν n
      Eigen::VectorXd sliding = {}; ///< e − u without it
      Eigen::VectorXd arm     = {}; ///< of obstacles that turn
      /// What obstacles that bear nothing do to come to touch: no work.
      Eigen::VectorXd approach = {};
    };

    static End end_of(const LinearElasticity &elasticity, const ContactSurface &surface,
                      const State &state);

    /// Adds W_obstacles, D and X.
    static void add_contact(Step &step, const End &before, const End &after,
                            const ContactSurface &surface, const State &state);

    End last_;
    double elastic_energy_ = 0.;
    bool is_carried_       = false; ///< the last end, from another mesh
  };
} // namespace stiction
