#pragma once

#include <stiction/output/results/run_result.h>
#include <stiction/simulation/solvers/contact_solver.h>

namespace stiction
{
  /// Finds a state to begin with where 'Contact refinement' leaves no levels to begin on:
  /// solves the problem on the body without it, to a few digits, takes the answer to the
  /// body refined once, and so on. Newton steps on the mesh itself then begin with its
  /// contact set but for a row of cells; from nothing it grows by some rows a step, and
  /// may never settle.
  class CoarserMeshes
  {
  public:
    /// The setting must outlive the object.
    explicit CoarserMeshes(const ContactSolver::Setting &setting);

    /// Whether this mesh is the one that 'Contact refinement' makes, and contact that of
    /// the mesh alone: with 'Sliding = far' obstacles are where the answer is, and
    /// elements that lock do so more on coarser meshes, whose answers are worth nothing
    /// then.
    static bool are_there(const ContactSolver::Setting &setting);

    /// A state on the mesh of the setting, empty if the last mesh before it has none that
    /// is worth more than nothing, or contact there is no valid one. Collective.
    ///
    /// Throws Interrupted if the observer does.
    ///
    /// @param known distances of pressed obstacles, as far as they are known.
    /// @param last the last step before, in and out, from which steps are counted on.
    /// @param observer called after every step; may throw Interrupted on all ranks.
    State find(const State &known, ContactStep &last,
               const ContactSolver::Observer &observer);

    /// What all calls of find() did.
    const RunResult::Solver &statistics() const { return statistics_; }

  private:
    const ContactSolver::Setting &setting_;
    RunResult::Solver statistics_;
  };
} // namespace stiction
