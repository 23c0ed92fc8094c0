#include <stiction/base/log.h>
#include <stiction/base/phases.h>
#include <stiction/contact/certificate/body_verifier.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/obstacles/force_control.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/solvers/multigrid_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/results/summary.h>
#include <stiction/parameters/parameters.h>
#include <stiction/simulation/primal_contact_solver.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <nlohmann/json.hpp>

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

  ContactSolution PrimalContactSolver::solve(const Observer &observer)
  {
    const auto phase = setting_.phases.scope("displacement_iteration");
    const ContactSolverParameters &chosen = setting_.parameters.contact_solver;
    ContactSolution solution = newton_->solve(chosen.tolerance, chosen.maximum_iterations,
                                              observer, setting_.control);
    if (setting_.control != nullptr)
      setting_.surface.move_obstacles(setting_.control->distances());
    return solution;
  }

  void PrimalContactSolver::verify(ContactSolution &solution)
  {
    stiffness_solver_ = std::make_unique<MultigridSolver>(
      setting_.elasticity, newton_->free_preconditioner(), newton_->finest_level(),
      duality_gap_accuracy);
    verifier_ = std::make_unique<BodyVerifier>(setting_.elasticity, setting_.surface,
                                               *stiffness_solver_);
    verifier_->verify(newton_->displacement(), solution.lambda);
    solution.converged =
      verifier_->certificate().converged(setting_.parameters.contact_solver.tolerance);
    if (!solution.converged && !solution.interrupted && solution.reason.empty())
      solution.reason = "the certificate measures more than the iteration did, "
                        "raise 'Contact solver/Tolerance'";
  }

  nlohmann::json PrimalContactSolver::to_json() const
  {
    return solver_to_json(setting_.parameters.contact_solver, *newton_);
  }
} // namespace stiction
