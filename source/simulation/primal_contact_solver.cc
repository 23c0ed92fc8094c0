#include <stiction/base/log.h>
#include <stiction/base/phases.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/solvers/multigrid_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/results/run_result.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/primal_contact_solver.h>

namespace stiction
{
  namespace
  {
    // The duality gap needs a few digits of one more elastic solve only.
    constexpr double duality_gap_accuracy = 1e-6;
  } // namespace

  PrimalContactSolver::PrimalContactSolver(const Setting &setting)
    : ContactSolver(setting)
  {
    const auto phase             = setting_.phases.scope("stiffness_setup");
    const Parameters &parameters = setting_.parameters;
    print_progress("Newton method in displacements: " +
                   parameters.stiffness_solver_type());
    LevelNewton::Options options;
    options.other_method = other_method();
    newton_ = std::make_unique<NewtonMultigrid>(setting_.elasticity, setting_.surface,
                                                parameters.is_matrix_free(), options);
  }

  PrimalContactSolver::~PrimalContactSolver() = default;

  SolveStatus PrimalContactSolver::solve(State &state, const Observer &observer)
  {
    const auto phase = setting_.phases.scope("displacement_iteration");
    const ContactSolverParameters &chosen = setting_.parameters.contact_solver;
    const SolveStatus status =
      newton_->solve(state, chosen.tolerance, chosen.maximum_iterations, observer);
    setting_.elasticity.distribute(state.u);
    return status;
  }

  void PrimalContactSolver::update()
  {
    newton_->update();
  }

  StiffnessSolver &PrimalContactSolver::stiffness_solver()
  {
    stiffness_solver_ = std::make_unique<MultigridSolver>(
      setting_.elasticity, newton_->preconditioner(), newton_->finest_level(),
      newton_->free_supports(), duality_gap_accuracy);
    return *stiffness_solver_;
  }

  void PrimalContactSolver::add_to(RunResult &result) const
  {
    add_method(result.solver, *newton_);
  }
} // namespace stiction
