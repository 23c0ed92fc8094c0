// How a problem is solved and certified on one mesh.

#include <stiction/base/interrupt.h>
#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/body_verifier.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/dual/dual_method_factory.h>
#include <stiction/contact/dual/schur_complement.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/obstacles/pressed_obstacles.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/solvers/multigrid_solver.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/results/convergence_history.h>
#include <stiction/parameters/parameters.h>
#include <stiction/simulation/contact_problem.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace stiction
{
  namespace
  {
    // An iterative solver stops here, far enough below the tolerance that the
    // certificate does not see it.
    constexpr double linear_solver_safety = 1e-4;

    constexpr double duality_gap_accuracy = 1e-6;

    // Where forces press obstacles on, the contact forces are wanted better
    // than the tolerance: how they change from one place to another matters.
    constexpr double fixed_obstacle_accuracy = 0.1;

  } // namespace



  void
  ContactProblem::set_up_stiffness_solver()
  {
    const auto phase  = phases_.scope("stiffness_setup");
    stiffness_solver_ = StiffnessSolver::create(
      parameters_.stiffness_solver_type(),
      *elasticity_,
      linear_solver_safety * parameters_.contact_solver.tolerance);
  }



  void
  ContactProblem::set_up_dual_operator()
  {
    const auto phase = phases_.scope("dual_operator");
    if (parameters_.output.print_progress)
      log_->line("Dual operator: " + parameters_.dual_operator.form + ", " +
                 parameters_.stiffness_solver_type());
    schur_ = SchurComplement::create(parameters_.dual_operator.form,
                                     *elasticity_,
                                     *surface_,
                                     *stiffness_solver_);
  }



  void
  ContactProblem::finish_step(const ContactStep &step)
  {
    history_->add(step);
    if (!step.remark.empty() && parameters_.output.print_progress)
      log_->line(step.remark);
    stop_if_interrupted(communicator_);
  }



  std::string
  ContactProblem::other_method() const
  {
    return advice_on_method(
      parameters_, surface_->slip_bound().is_coulomb(), true);
  }



  void
  ContactProblem::set_up_multigrid()
  {
    const auto phase = phases_.scope("stiffness_setup");
    if (parameters_.output.print_progress)
      log_->line("Newton method in displacements: " +
                 parameters_.stiffness_solver_type());
    LevelNewton::Options options;
    options.other_method = other_method();
    newton_              = std::make_unique<NewtonMultigrid>(
      *elasticity_, *surface_, parameters_.is_matrix_free(), options);
  }



  void
  ContactProblem::solve_for_displacements()
  {
    const auto phase = phases_.scope("displacement_iteration");
    solution_        = std::make_unique<ContactSolution>(newton_->solve(
      parameters_.contact_solver.tolerance,
      parameters_.contact_solver.maximum_iterations,
      [&](const ContactStep &step) { finish_step(step); },
      force_control_.get()));
    if (force_control_)
      surface_->move_obstacles(force_control_->distances());
  }



  void
  ContactProblem::solve_for_contact_forces()
  {
    const auto phase = phases_.scope("dual_iteration");
    method_          = create_dual_method(
      parameters_.contact_solver, *schur_, surface_->slip_bound().is_coulomb());
    verifier_ =
      std::make_unique<BodyVerifier>(*elasticity_, *surface_, *stiffness_solver_);
    const double tolerance = parameters_.contact_solver.tolerance;
    const auto solve = [&](const double accuracy, const Eigen::VectorXd &from) {
      solution_ = std::make_unique<ContactSolution>(certified_solve(
        *method_,
        *schur_,
        surface_->slip_bound(),
        *verifier_,
        accuracy,
        parameters_.contact_solver.maximum_iterations,
        other_method(),
        [&](const ContactStep &step) { finish_step(step); },
        from));
    };
    if (!force_control_)
      return solve(tolerance, Eigen::VectorXd());

    const Units units = Units::named(parameters_.output.units);
    Eigen::VectorXd start; // none on a new mesh
    const std::string reason = force_control_->press(
      [&](const double accuracy) {
        schur_->shift_right_hand_side(
          -surface_->move_obstacles(force_control_->distances()));
        solve(accuracy, start);
        start                          = solution_->lambda;
        const Certificate &certificate = verifier_->certificate();
        auto outcome = outcome_of(surface_->motion().directions(),
                                  certificate.lambda(),
                                  certificate.gradient(),
                                  certificate.force_scale());
        if (!certificate.is_solved(std::max(accuracy, tolerance)))
          outcome.reason = solution_->reason;
        if (solution_->interrupted)
          outcome.reason = "interrupted";
        if (parameters_.output.print_progress)
          for (Eigen::Index j = 0; j < outcome.forces.size(); ++j)
            log_->line(
              "  obstacle moved by " +
              with_unit(format("%.6g", force_control_->distances()(j)),
                        units.length) +
              " presses with " +
              with_unit(format("%.6g", outcome.forces(j)), units.force));
        return outcome;
      },
      tolerance,
      fixed_obstacle_accuracy * tolerance);
    solution_->converged = verifier_->certificate().converged(tolerance);
    solution_->reason    = reason;
  }



  void
  ContactProblem::certify()
  {
    const auto phase = phases_.scope("certificate");
    // the dual iteration had its last iterate judged already
    if (newton_)
      verify_displacement();
    compute_duality_gap();
  }



  void
  ContactProblem::verify_displacement()
  {
    // the duality gap needs a few digits of one more solve only
    stiffness_solver_ =
      std::make_unique<MultigridSolver>(*elasticity_,
                                        newton_->free_preconditioner(),
                                        newton_->finest_level(),
                                        duality_gap_accuracy);
    verifier_ =
      std::make_unique<BodyVerifier>(*elasticity_, *surface_, *stiffness_solver_);
    verifier_->verify(newton_->displacement(), solution_->lambda);
    solution_->converged =
      verifier_->certificate().converged(parameters_.contact_solver.tolerance);
    if (!solution_->converged && !solution_->interrupted &&
        solution_->reason.empty())
      solution_->reason = "the certificate measures more than the iteration "
                          "did, raise 'Contact solver/Tolerance'";
  }



  void
  ContactProblem::compute_duality_gap()
  {
    if (newton_ && !solution_->lambda.allFinite())
      return;
    if (solution_->interrupted && !solution_->converged)
      return; // a figure that only informs, and an elastic solve
    try
      {
        verifier_->certificate().compute_duality_gap(verifier_->displacement(),
                                                  *stiffness_solver_);
      }
    catch (const std::runtime_error &)
      {
        if (!newton_)
          throw;
        // A figure that only informs: on very flat cells conjugate gradients
        // may fail where the method itself did not.
        log_->line("The duality gap was not computed: its elastic solve did "
                   "not converge.");
      }
  }
} // namespace stiction
