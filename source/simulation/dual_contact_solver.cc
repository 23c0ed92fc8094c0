#include <stiction/base/log.h>
#include <stiction/base/phases.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/body_verifier.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/dual/dual_method_factory.h>
#include <stiction/contact/dual/schur_complement.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/obstacles/pressed_obstacles.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/output/results/summary.h>
#include <stiction/parameters/parameters.h>
#include <stiction/simulation/dual_contact_solver.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace stiction
{
  namespace
  {
    // An iterative solver stops here, far enough below the tolerance that the
    // certificate does not see it.
    constexpr double linear_solver_safety = 1e-4;

    // Where forces press obstacles on, the contact forces are wanted better
    // than the tolerance: how they change from one place to another matters.
    constexpr double fixed_obstacle_accuracy = 0.1;
  } // namespace

  DualContactSolver::DualContactSolver(const Setting &setting)
    : ContactSolver(setting)
  {
    set_up_stiffness_solver();
    set_up_dual_operator();
  }

  DualContactSolver::~DualContactSolver() = default;

  void DualContactSolver::set_up_stiffness_solver()
  {
    const auto phase             = setting_.phases.scope("stiffness_setup");
    const Parameters &parameters = setting_.parameters;
    stiffness_solver_ =
      StiffnessSolver::create(parameters.stiffness_solver_type(), setting_.elasticity,
                              linear_solver_safety * parameters.contact_solver.tolerance);
  }

  void DualContactSolver::set_up_dual_operator()
  {
    const auto phase             = setting_.phases.scope("dual_operator");
    const Parameters &parameters = setting_.parameters;
    print_progress("Dual operator: " + parameters.dual_operator.form + ", " +
                   parameters.stiffness_solver_type());
    Q_ = SchurComplement::create(parameters.dual_operator.form, setting_.elasticity,
                                 setting_.surface, *stiffness_solver_);
  }

  ContactSolution DualContactSolver::solve_there(const double tolerance,
                                                 const Eigen::VectorXd &start,
                                                 const Observer &observer)
  {
    return certified_solve(*method_, *Q_, setting_.surface.slip_bound(), *verifier_,
                           tolerance,
                           setting_.parameters.contact_solver.maximum_iterations,
                           other_method(), observer, start);
  }

  ContactSolution DualContactSolver::solve(const Observer &observer)
  {
    const auto phase                      = setting_.phases.scope("dual_iteration");
    ContactSurface &surface               = setting_.surface;
    const ContactSolverParameters &chosen = setting_.parameters.contact_solver;
    method_ = create_dual_method(chosen, *Q_, surface.slip_bound().is_coulomb());
    verifier_ =
      std::make_unique<BodyVerifier>(setting_.elasticity, surface, *stiffness_solver_);
    if (setting_.control == nullptr)
      return solve_there(chosen.tolerance, {}, observer);

    ForceControl &control = *setting_.control;
    const Units units     = Units::named(setting_.parameters.output.units);
    ContactSolution solution; // no start on a new mesh
    const std::string reason = control.press(
      [&](const double accuracy) {
        Q_->shift_right_hand_side(-surface.move_obstacles(control.distances()));
        solution                       = solve_there(accuracy, solution.lambda, observer);
        const Certificate &certificate = verifier_->certificate();
        auto outcome = outcome_of(surface.motion().directions(), certificate.lambda(),
                                  certificate.gradient(), certificate.force_scale());
        if (!certificate.is_solved(std::max(accuracy, chosen.tolerance)))
          outcome.reason = solution.reason;
        if (solution.interrupted)
          outcome.reason = "interrupted";
        for (Eigen::Index j = 0; j < outcome.forces.size(); ++j)
          print_progress("  obstacle moved by " +
                         with_unit(format("%.6g", control.distances()(j)), units.length) +
                         " presses with " +
                         with_unit(format("%.6g", outcome.forces(j)), units.force));
        return outcome;
      },
      chosen.tolerance, fixed_obstacle_accuracy * chosen.tolerance);
    solution.converged = verifier_->certificate().converged(chosen.tolerance);
    solution.reason    = reason;
    return solution;
  }

  nlohmann::json DualContactSolver::to_json() const
  {
    nlohmann::json json      = solver_to_json(setting_.parameters.contact_solver,
                                              setting_.surface.slip_bound(), *method_, *Q_);
    json["stiffness_solves"] = stiffness_solver_->n_solves();
    json["stiffness_krylov_iterations"] = stiffness_solver_->n_iterations();
    return json;
  }
} // namespace stiction
