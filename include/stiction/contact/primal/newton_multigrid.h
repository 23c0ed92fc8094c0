#pragma once

#include <stiction/contact/primal/contact_level.h>
#include <stiction/contact/primal/contact_state.h>
#include <stiction/contact/primal/level_newton.h>
#include <stiction/elasticity/levels/dof_subset_hierarchy.h>
#include <stiction/elasticity/levels/mesh_hierarchy.h>
#include <stiction/elasticity/multigrid/multigrid.h>
#include <stiction/qp/certified_solve.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;

  /// Contact with friction for the price of about two elastic solves: the
  /// semismooth Newton method in displacements (PrimalActiveSet), each step
  /// solved inexactly with a multigrid preconditioner (NewtonSystem), on the
  /// levels of the mesh one after the other.
  /// source/contact/primal/newton_multigrid.md derives it.
  class NewtonMultigrid
  {
  public:
    /// A coarse level or mesh need not be solved better than it approximates the next:
    /// from 0.1 to 1e-4 the steps on the finest level are the same. What is found there
    /// with a larger residual than the second is worth less than nothing.
    static constexpr double coarse_tolerance = 0.03, worthless = 1.;

    /// A start is not worth what an answer is.
    static LevelNewton::Options for_start(LevelNewton::Options options = {});

    /// @param levels_in_use whether to use the levels of the mesh; otherwise
    ///   the preconditioner is algebraic. The arguments must outlive the
    ///   object. Collective.
    NewtonMultigrid(const LinearElasticity &elasticity, const ContactSurface &surface,
                    bool levels_in_use, LevelNewton::Options options = {});

    /// Takes loads, supports, gaps, frames and friction afresh from elasticity and
    /// surface; B must be what it was, or is_turned(). Collective.
    void update();

    /// Called after every step on any level. If it throws Interrupted, on all
    /// ranks, the iterate of that step is interpolated to the finest level and
    /// handed back.
    using Observer = std::function<void(const ContactStep &)>;

    /// A state to begin with on the finest level where Newton steps come no closer,
    /// without a displacement if there is none. The last step is its argument, from
    /// which it counts on.
    using OtherStart = std::function<State(ContactStep &)>;

    /// Solves the problem to the tolerance, in the figures of the certificate.
    /// Collective.
    ///
    /// @param solution in: what is known of the solution: a displacement
    ///   near the solution, from which the finest level begins, and distances of
    ///   pressed obstacles, from which the coarsest one does; out: the solution.
    /// @param other_start called at most once, where Newton steps on the finest level
    /// come
    ///   no closer, before an interior point method takes turns with them; none if empty.
    /// @param before the last step of another solve, from which steps and iterations are
    ///   counted on.
    SolveStatus solve(State &solution, double tolerance, unsigned int max_steps,
                      const Observer &observer, const OtherStart &other_start = {},
                      const ContactStep &before = {});

    /// What all calls of solve() did, from the coarsest level to the mesh itself.
    const std::vector<LevelNewton::Statistics> &statistics() const { return statistics_; }

    /// The unknowns of a level.
    dealii::types::global_dof_index n_dofs(const unsigned int level) const
    {
      return hierarchy_.level(level).n_dofs();
    }

    /// The preconditioner, for other systems with K on the finest level.
    Multigrid &preconditioner() { return multigrid_; }

    /// Its supports without contact.
    NodalSupports free_supports() const;

    unsigned int finest_level() const { return hierarchy_.n_levels() - 1; }

  private:
    /// Where to begin: on the finest level if what is known is near the solution.
    unsigned int first_level(const State &known);

    /// Begins on a level: with the known displacement if it is the finest one and
    /// there is one, with none otherwise. Returns the known contact forces.
    Eigen::VectorXd begin(unsigned int level, const State &known);

    /// Interpolates the state to this level from the one below. Returns the
    /// interpolated contact forces.
    Eigen::VectorXd refine(unsigned int level);

    const LevelNewton::Options options_;
    const bool is_held_by_contact_; ///< a body, alone
    MeshHierarchy hierarchy_;
    DofSubsetHierarchy dof_hierarchy_;
    Multigrid multigrid_;
    std::vector<std::unique_ptr<ContactLevel>> problems_;
    std::optional<ContactState>
      state_; ///< of the present level; LevelNewton refers to it
    std::vector<LevelNewton::Statistics> statistics_;
  };
} // namespace stiction
