#include <stiction/base/log.h>
#include <stiction/base/phases.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/body_verifier.h>
#include <stiction/contact/dual/dual_method_factory.h>
#include <stiction/contact/dual/schur_complement.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/obstacles/pressed_obstacles.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/output/results/summary.h>
#include <stiction/parameters/parameters.h>
#include <stiction/qp/operators/augmented_operator.h>
#include <stiction/simulation/dual_contact_solver.h>

#include <nlohmann/json.hpp>

namespace stiction
{
  namespace
  {
    // An iterative solver stops here, far enough below the tolerance that the
    // certificate does not see it.
    constexpr double linear_solver_safety = 1e-4;

    // The compliance of the springs that obstacles are pressed on with, over that
    // of the body: the error of the forces falls by about this factor with each
    // solve.
    constexpr double spring_compliance = 1e3;

    // The springs are too stiff if the error falls by less.
    constexpr double required_fall      = 0.1;
    constexpr double softening          = 30.;
    constexpr unsigned int max_releases = 40;
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

  SolveStatus DualContactSolver::solve(State &state, const Observer &observer)
  {
    const auto phase = setting_.phases.scope("dual_iteration");
    if (setting_.surface.motion().n_pressed() > 0)
      return solve_pressed(state, observer);
    BodyVerifier verifier(setting_.elasticity, setting_.surface, *stiffness_solver_,
                          state,
                          [](const Eigen::VectorXd &) { return Eigen::VectorXd(); });
    Eigen::VectorXd lambda = state.lambda;
    return solve_with(*Q_, verifier, setting_.parameters.contact_solver.tolerance,
                      observer, lambda);
  }

  SolveStatus DualContactSolver::solve_with(const DualOperator &Q, BodyVerifier &verifier,
                                            const double tolerance,
                                            const Observer &observer,
                                            Eigen::VectorXd &lambda)
  {
    const ContactSolverParameters &chosen = setting_.parameters.contact_solver;
    const qp::SlipBound &slip_bound       = setting_.surface.slip_bound();
    if (!method_)
      method_ = create_dual_method(chosen, Q, slip_bound.is_coulomb());
    return certified_solve(*method_, Q, slip_bound, verifier, tolerance,
                           chosen.maximum_iterations, other_method(), observer, lambda);
  }

  Eigen::MatrixXd DualContactSolver::uniform_pressures() const
  {
    const ContactSurface &surface = setting_.surface;
    const ObstacleMotion &motion  = surface.motion();
    Eigen::MatrixXd lambda =
      Eigen::MatrixXd::Zero(3 * surface.n_nodes(), motion.n_pressed());
    for (Eigen::Index j = 0; j < motion.n_pressed(); ++j)
      {
        const Eigen::VectorXd approach =
          -motion.directions().col(j).head(surface.n_nodes());
        const Eigen::VectorXd met =
          (approach.array() > least_approach).select(surface.areas(), 0.);
        lambda.col(j).head(met.size()) = motion.forces()(j) / met.dot(approach) * met;
      }
    return lambda;
  }

  Eigen::VectorXd DualContactSolver::yielding(const Eigen::MatrixXd &lambda) const
  {
    Eigen::VectorXd ways(lambda.cols()), Q_lambda;
    for (Eigen::Index j = 0; j < ways.size(); ++j)
      {
        Q_->vmult(DualBlock::all, DualBlock::all, Q_lambda, lambda.col(j));
        ways(j) = lambda.col(j).dot(Q_lambda) / setting_.surface.motion().forces()(j);
      }
    return ways;
  }

  SolveStatus DualContactSolver::solve_pressed(State &state, const Observer &observer)
  {
    const ContactSurface &surface = setting_.surface;
    const ObstacleMotion &motion  = surface.motion();
    const double tolerance        = setting_.parameters.contact_solver.tolerance;
    const Units units             = Units::named(setting_.parameters.output.units);

    const Eigen::VectorXd ways =
      ways_to_press(motion, surface.gaps(), surface.areas(),
                    surface.stiffness().youngs_moduli.maxCoeff());
    const Eigen::MatrixXd pressures = uniform_pressures();
    Eigen::VectorXd lambda          = state.lambda;
    if (lambda.size() == 0)
      lambda = pressures.rowwise().sum();
    if (state.distances.size() == 0)
      state.distances = ways;
    Eigen::VectorXd weights =
      spring_compliance * (yielding(pressures) + ways).cwiseQuotient(motion.forces());
    BodyVerifier verifier(
      setting_.elasticity, surface, *stiffness_solver_, state,
      [&](const Eigen::VectorXd &lambda) { return augmented_->multipliers(lambda); });
    SolveStatus status;
    double last_error = 1.;
    augmented_.reset();
    for (unsigned int k = 0; k < max_releases; ++k)
      {
        if (!augmented_)
          {
            method_.reset();
            augmented_ = std::make_unique<AugmentedOperator>(
              *Q_, EqualityConstraint{motion.directions(), -motion.forces()},
              state.distances, weights);
          }
        status = solve_with(*augmented_, verifier, tolerance, observer, lambda);
        for (Eigen::Index j = 0; j < weights.size(); ++j)
          print_progress("  obstacle moved by " +
                         with_unit(format("%.6g", state.distances(j)), units.length) +
                         " presses with " +
                         with_unit(format("%.6g", motion.forces()(j) -
                                                    motion.missing_forces(lambda)(j)),
                                   units.force));
        const double error = motion.force_error(lambda);
        if (!status.converged || status.interrupted || error <= tolerance)
          return status;
        if (error > required_fall * last_error)
          {
            weights *= softening;
            augmented_.reset();
          }
        else
          augmented_->set_multipliers(state.distances);
        last_error = error;
      }
    status.reason = "no place of the obstacle was found where it presses with its force, "
                    "raise 'Contact solver/Tolerance' if the force is small beside the "
                    "others";
    return status;
  }

  nlohmann::json DualContactSolver::to_json() const
  {
    nlohmann::json json =
      solver_to_json(setting_.parameters.contact_solver, setting_.surface.slip_bound(),
                     *method_, augmented_ ? *augmented_ : *Q_);
    json["stiffness_solves"]            = stiffness_solver_->n_solves();
    json["stiffness_krylov_iterations"] = stiffness_solver_->n_iterations();
    return json;
  }
} // namespace stiction
