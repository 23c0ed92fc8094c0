#pragma once

#include <stiction/simulation/solvers/contact_solver.h>

namespace stiction
{
  class CoarserMeshes;
  class DualContactSolver;
  class NewtonMultigrid;

  /// Solves for displacements, by NewtonMultigrid. Where that stands still, or cannot
  /// take the order of the slaves, and the body is small enough for the dual operator,
  /// the dual method newton goes on.
  class PrimalContactSolver : public ContactSolver
  {
  public:
    explicit PrimalContactSolver(const Setting &setting);
    ~PrimalContactSolver() override;

    SolveStatus solve(State &state, const Observer &observer) override;

    void update() override;

    StiffnessSolver &stiffness_solver() override;

    void add_to(RunResult &result) const override;

  private:
    /// Whether the body and its dual operator are small enough. Collective.
    bool can_hand_over() const;

    /// Where the method is chosen, not said, and newton is known to be the better one:
    /// why. Else empty.
    std::string why_not_at_all() const;

    /// Newton steps, and where they come no closer from nothing, again from what coarser
    /// meshes find. Collective.
    SolveStatus solve_for_displacements(State &state, ContactStep &last,
                                        const Observer &observer);

    /// By the dual method newton. Collective.
    ///
    /// @param last the last step so far: steps are counted on.
    SolveStatus solve_dual(State &state, ContactStep &last, const Observer &observer);

    /// The same where Newton steps in displacements come no closer: from what they found
    /// if that is near, otherwise from nothing. Collective.
    SolveStatus hand_over(State &state, ContactStep &last, const Observer &observer);

    /// Whether nothing presses any more on a body that contact alone held. It may be an
    /// equilibrium beside the one that its history leads to: friction may hold a wedge
    /// without loads, and Newton steps in displacements find one or the other.
    ///
    /// @param before at the end of the load step before; empty: there was none.
    bool is_let_go(const State &before, const State &after) const;

    /// Solves a load step in which a body was let go once more, from where the one before
    /// ended, by newton, which begins with the forces. Collective.
    ///
    /// @param state as it was let go; remains so unless newton finds it held.
    /// @param status of that. @return the status of the state that is left.
    SolveStatus look_whether_held(SolveStatus status, const State &before, State &state,
                                  ContactStep &last, const Observer &observer);

    const bool can_hand_over_;
    std::unique_ptr<CoarserMeshes> coarser_meshes_; ///< if there are some
    std::unique_ptr<NewtonMultigrid> newton_; ///< none where it is left to newton at once
    std::unique_ptr<DualContactSolver> dual_; ///< once it was needed
    bool is_dual_alone_ = false;              ///< from the next step on: it was the one
  };
} // namespace stiction
