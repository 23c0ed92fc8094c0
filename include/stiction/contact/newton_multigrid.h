#ifndef stiction_contact_newton_multigrid_h
#define stiction_contact_newton_multigrid_h

#include <stiction/contact/certified_solve.h>
#include <stiction/contact/contact_level.h>
#include <stiction/contact/contact_state.h>
#include <stiction/contact/supported_system.h>
#include <stiction/elasticity/mesh_hierarchy.h>
#include <stiction/elasticity/multigrid.h>
#include <stiction/elasticity/trace_hierarchy.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;

  /// Contact with friction for the price of about two elastic solves: the
  /// semismooth Newton method in displacements (PrimalLinearization), each step
  /// solved inexactly with a multigrid preconditioner (SupportedSystem), on the
  /// levels of the mesh one after the other. doc/newton_multigrid.md derives it.
  class NewtonMultigrid
  {
  public:
    /// What no user has to set. The answer does not depend on it.
    struct Options
    {
      /// ρ over the mean diagonal entry of K at a node, at the start.
      double first_c = 0.1;
    };

    /// @param levels_in_use whether to use the levels of the mesh; otherwise
    ///   the preconditioner is algebraic. The arguments must outlive the
    ///   object. Collective.
    NewtonMultigrid(const LinearElasticity &elasticity,
                    const ContactSurface &surface,
                    bool levels_in_use,
                    const Options &options);

    /// What was done on a level.
    struct LevelStatistics
    {
      unsigned long dofs             = 0;
      unsigned int newton_steps      = 0;
      unsigned int krylov_iterations = 0;
      unsigned int reductions        = 0; ///< of ρ
      unsigned int fallbacks         = 0;
    };

    /// A row of the history, with the level it belongs to.
    using Observer = std::function<void(const ContactStep &)>;

    /// Solves the problem to the tolerance, in the figures of the certificate.
    /// Collective.
    ContactSolution
    solve(double tolerance, unsigned int max_steps, const Observer &observer);

    /// The displacement found, m.
    const LA::Vector &
    displacement() const
    {
      return state_->u;
    }

    /// From the coarsest level to the mesh itself.
    const std::vector<LevelStatistics> &
    statistics() const
    {
      return statistics_;
    }

    /// For other systems with K on the mesh.
    StiffnessPreconditioner &
    preconditioner()
    {
      return multigrid_;
    }
    unsigned int
    finest_level() const
    {
      return hierarchy_.n_levels() - 1;
    }

  private:
    /// How the Newton iteration on a level ended.
    struct LevelResult
    {
      bool converged = false;
      std::string reason;
    };

    LevelResult
    solve_level(unsigned int level,
                double tolerance,
                unsigned int max_steps,
                const Eigen::VectorXd &first_lambda,
                const Observer &observer);

    void
    prolongate(unsigned int level, Eigen::VectorXd &lambda);

    const Options options_;
    MeshHierarchy hierarchy_;
    TraceHierarchy trace_hierarchy_;
    Multigrid multigrid_;
    std::vector<std::unique_ptr<ContactLevel>> problems_;
    std::unique_ptr<ContactState> state_;
    std::vector<LevelStatistics> statistics_;
    ContactStep row_;
  };
} // namespace stiction

#endif
