#include <stiction/base/log.h>
#include <stiction/base/phases.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/dual/dual_method_factory.h>
#include <stiction/contact/dual/motion_search.h>
#include <stiction/contact/dual/rigid_balance.h>
#include <stiction/contact/dual/schur_complement.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/obstacles/place_search.h>
#include <stiction/contact/obstacles/pressed_obstacles.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/results/run_result.h>
#include <stiction/qp/operators/augmented_operator.h>
#include <stiction/qp/operators/deflated_operator.h>
#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/sensitivity.h>
#include <stiction/simulation/parameters/memory_estimates.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/solvers/dual_contact_solver.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
    // An iterative solver stops here, far enough below the tolerance that the
    // certificate does not see it.
    constexpr double linear_solver_safety = 1e-4;

    // The springs that press obstacles on are too stiff if the error of the forces
    // falls by less in a solve.
    constexpr double required_fall      = 0.7;
    constexpr double softening          = 3.;
    constexpr unsigned int max_releases = 40, max_softened = 6;

    // What is less than so much of the largest resistance is rounding.
    constexpr double unresisted = 1e-9;

    // The contact problem need not be solved better than so much less than the error
    // of the forces, from this accuracy on.
    constexpr double accuracy_of_error = 0.1;
    constexpr double first_accuracy    = 1e-2;

    const char *const no_place_of_obstacle =
      "no place of the obstacle was found where it presses with its force, ";
    const char *const no_place_of_body =
      "no place of the body was found where contact holds it (do the loads ask for more "
      "than friction bears, is a gap too large, is a support missing?), ";
  } // namespace

  DualContactSolver::DualContactSolver(const Setting &setting,
                                       std::set<std::string> tried)
    : ContactSolver(setting)
    , tried_(std::move(tried))
  {
    set_up_stiffness_solver();
    set_up_dual_operator();
  }

  DualContactSolver::~DualContactSolver() = default;

  std::string DualContactSolver::stiffness_solver_type() const
  {
    const Parameters &parameters = setting_.parameters;
    // multigrid may be why another method came no closer
    const bool is_free = parameters.stiffness_solver.type == "automatic" ||
                         tried_.count("newton multigrid") > 0;
    return parameters.contact_solver.is_primal() && is_free
             ? "mumps"
             : parameters.stiffness_solver_type();
  }

  void DualContactSolver::set_up_stiffness_solver()
  {
    const auto phase             = setting_.phases.scope("stiffness_setup");
    const Parameters &parameters = setting_.parameters;
    stiffness_solver_ =
      StiffnessSolver::create(stiffness_solver_type(), setting_.elasticity,
                              linear_solver_safety * parameters.contact_solver.tolerance);
  }

  void DualContactSolver::set_up_dual_operator()
  {
    const auto phase             = setting_.phases.scope("dual_operator");
    B_                           = setting_.surface.B();
    const Parameters &parameters = setting_.parameters;
    const auto n_unknowns        = B_.all_dofs().size();
    const bool has_memory =
      tried_.empty() ||
      has_memory_to_hand_over(parameters, static_cast<double>(n_unknowns),
                              setting_.elasticity.body().communicator());
    const std::string form = has_memory ? parameters.dual_operator.form : "by solves";
    const bool by_columns  = form == "assembled" && stiffness_solver_type() != "mumps";
    print_progress("Dual operator: " + form + ", " + stiffness_solver_type() +
                   (by_columns ? format(": %ld elastic solves", n_unknowns) : ""));
    Q_ = SchurComplement::create(form, setting_.elasticity, setting_.surface,
                                 *stiffness_solver_);
  }

  void DualContactSolver::update()
  {
    forget_method(); // a run that goes on from a checkpoint knows nothing of it
    const LinearElasticity &elasticity = setting_.elasticity;
    const ContactSurface &surface      = setting_.surface;
    if (Q_->matrix() == nullptr || B_ == surface.B())
      {
        Q_->set_right_hand_side(
          SchurComplement::right_hand_side_of(elasticity, surface, *stiffness_solver_));
        return;
      }
    // the frames have turned, and will again
    if (compliance_.size() == 0)
      compliance_ = SchurComplement::compliance(elasticity, surface, *stiffness_solver_);
    earlier_multiplications_ += present_operator().n_multiplications();
    augmented_.reset();
    deflated_.reset();
    Q_.reset();
    Q_ = SchurComplement::assembled(compliance_, elasticity, surface, *stiffness_solver_);
    B_ = surface.B();
  }

  SolveStatus DualContactSolver::solve(State &state, const Observer &observer)
  {
    const auto phase = setting_.phases.scope("dual_iteration");
    if (setting_.surface.motion().n_pressed() > 0 ||
        setting_.elasticity.free_motions().n() > 0)
      return solve_balanced(state, observer);
    BodyVerifier verifier(setting_.elasticity, setting_.surface, *stiffness_solver_,
                          state,
                          [](const Eigen::VectorXd &) { return BodyVerifier::Places(); });
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
    const bool friction_holds =
      setting_.elasticity.free_motions().n() > 0 && slip_bound.largest_coefficient() > 0.;
    return certified_solve(
      *method_, Q, slip_bound, verifier, tolerance, chosen.maximum_iterations,
      (friction_holds ? "see whether the loads ask for more than friction bears or a "
                        "support is missing, or "
                      : "") +
        other_method(tried_),
      observer, lambda);
  }

  const DualOperator &DualContactSolver::present_operator() const
  {
    return augmented_ ? *augmented_ : *Q_;
  }

  void DualContactSolver::forget_method()
  {
    if (method_)
      earlier_ += method_->statistics();
    method_.reset();
  }

  Eigen::VectorXd DualContactSolver::yielding(const DualOperator &Q,
                                              const Eigen::MatrixXd &lambda) const
  {
    Eigen::VectorXd ways(lambda.cols()), Q_lambda;
    for (Eigen::Index j = 0; j < ways.size(); ++j)
      {
        Q.vmult(DualBlock::all, DualBlock::all, Q_lambda, lambda.col(j));
        ways(j) = lambda.col(j).dot(Q_lambda) / setting_.surface.motion().forces()(j);
      }
    return ways;
  }

  BodyVerifier::Places DualContactSolver::places(const Eigen::VectorXd &multipliers,
                                                 const Eigen::VectorXd &lambda) const
  {
    const Eigen::Index p = setting_.surface.motion().n_pressed();
    if (!deflated_)
      return {multipliers, {}, {}};
    return {multipliers.head(p),
            deflated_->multipliers(multipliers.tail(multipliers.size() - p), lambda),
            deflated_->lacking(lambda)};
  }

  qp::RigidPlace DualContactSolver::first_guess(const State &state,
                                                const EqualityConstraint &balance) const
  {
    const ContactSurface &surface     = setting_.surface;
    const LinearElasticity &body      = setting_.elasticity;
    const ContactStiffness &stiffness = surface.stiffness();
    const bool is_warm                = state.lambda.size() > 0;
    if (body.free_motions().n() > 0)
      {
        if (is_warm && state.distances.size() == surface.motion().n_pressed())
          {
            Eigen::VectorXd places(balance.e.size());
            places << state.distances, body.free_motion_of(state.u);
            return {places, state.lambda};
          }
        return qp::rigid_place(
          balance, surface.motion().offset_at_start(),
          stiffness.youngs_moduli.cwiseProduct(surface.areas().cwiseSqrt()),
          surface.slip_bound());
      }
    return {state.distances.size() > 0
              ? state.distances
              : ways_to_press(surface.motion(), surface.gaps(), surface.areas(),
                              stiffness.youngs_moduli.maxCoeff()),
            is_warm
              ? state.lambda
              : Eigen::VectorXd(
                  uniform_pressures(surface.motion(), surface.areas()).rowwise().sum())};
  }

  void DualContactSolver::augment(const EqualityConstraint &balance,
                                  const Eigen::VectorXd &start,
                                  const Eigen::VectorXd &lambda)
  {
    const ContactSurface &surface         = setting_.surface;
    const ObstacleMotion &motion          = surface.motion();
    const Eigen::Index p                  = motion.n_pressed();
    const Eigen::Index n                  = balance.e.size() - p;
    const ContactSolverParameters &chosen = setting_.parameters.contact_solver;

    EqualityConstraint constraint{balance.G.leftCols(p), balance.e.head(p)};
    Eigen::VectorXd multipliers = start.head(p);
    deflated_.reset();
    if (n > 0)
      deflated_ = std::make_unique<DeflatedOperator>(
        *Q_, EqualityConstraint{balance.G.rightCols(n), balance.e.tail(n)});
    const DualOperator &Q =
      deflated_ ? static_cast<const DualOperator &>(*deflated_) : *Q_;
    Eigen::VectorXd weights = best_spring_compliance(chosen) *
                              yielding(Q, uniform_pressures(motion, surface.areas()))
                                .cwiseQuotient(motion.forces());
    if (n > 0)
      {
        const EqualityConstraint &of_basis = deflated_->constraint();
        const Eigen::Index k               = of_basis.e.size();
        const double norm = qp::spectral_norm(Q.diagonal_block(DualBlock::all));
        constraint.G.conservativeResize(3 * surface.n_nodes(), p + k);
        constraint.G.rightCols(k) = of_basis.G;
        constraint.e.conservativeResize(p + k);
        constraint.e.tail(k) = of_basis.e;
        multipliers.conservativeResize(p + k);
        multipliers.tail(k) = deflated_->multipliers_of_basis(start.tail(n), lambda);
        weights.conservativeResize(p + k);
        weights.tail(k).setConstant(best_balance_weight(chosen) * norm);
      }
    if (augmented_)
      earlier_multiplications_ += augmented_->n_multiplications();
    augmented_ = std::make_unique<AugmentedOperator>(Q, std::move(constraint),
                                                     std::move(multipliers), weights);
  }

  SolveStatus DualContactSolver::solve_balanced(State &state, const Observer &observer)
  {
    const ContactSurface &surface         = setting_.surface;
    const ObstacleMotion &motion          = surface.motion();
    const ContactSolverParameters &chosen = setting_.parameters.contact_solver;
    const double tolerance                = chosen.tolerance;

    forget_method();
    const EqualityConstraint balance = rigid_balance(setting_.elasticity, surface);
    const auto [start, first_lambda] = first_guess(state, balance);
    augment(balance, start, first_lambda);
    Eigen::VectorXd lambda = first_lambda;
    if (lambda.isZero(0.))
      lambda.resize(0); // nothing is known
    BodyVerifier verifier(setting_.elasticity, surface, *stiffness_solver_, state,
                          [&](const Eigen::VectorXd &forces) {
                            return places(augmented_->multipliers(forces), forces);
                          });

    State best; // where the forces are least wrong
    PlaceSearch search(motion.forces());
    MotionSearch motion_search;

    double last_error = std::numeric_limits<double>::infinity(), smallest = last_error;
    double accuracy = std::max(first_accuracy, tolerance), share = 1., floor = 0.;
    unsigned int n_softened = 0;
    SolveStatus status;
    for (unsigned int k = 0; k < max_releases; ++k)
      {
        status = solve_with(*augmented_, verifier, std::max(share * accuracy, floor),
                            observer, lambda);
        print_places(state);

        const Certificate &certificate = verifier.certificate();
        const Eigen::VectorXd missing  = motion.missing_forces(lambda);
        double error                   = motion.relative_error(missing);
        if (deflated_)
          error = std::max(error, certificate.body_figures().equilibrium_residual);
        const bool falls = error <= required_fall * last_error;
        if (error < smallest)
          best = state;
        smallest = std::min(smallest, error);
        if (status.interrupted || certificate.converged(tolerance))
          return status;
        // where rounding ends a solve the forces may come nearer nevertheless
        const double reach = reach_of_rounding(certificate.rounding());
        if (!status.converged && !(falls && certificate.is_solved(reach)))
          break;

        Eigen::VectorXd next = augmented_->multipliers(lambda);
        if (!deflated_)
          next = search.next(state.distances, missing, accuracy);
        else
          next = motion_search.next(augmented_->multipliers(), next, error,
                                    [&]() { return newton_step(lambda); });
        augmented_->set_multipliers(next);
        // beside larger loads the forces may have been below the accuracy
        if (motion.n_pressed() > 0)
          share = std::min(motion.forces().minCoeff() / certificate.force_scale(), 1.);
        floor = 10. * certificate.rounding();
        if (!falls && accuracy == tolerance)
          {
            if (++n_softened > max_softened)
              break;
            augmented_->scale_weights(softening);
            forget_method();
          }
        accuracy =
          std::max(tolerance, std::min(accuracy_of_error * error,
                                       falls ? accuracy : accuracy_of_error * accuracy));
        last_error = error;
      }
    if (status.converged)
      status.reason = (motion.n_pressed() > 0 ? no_place_of_obstacle : no_place_of_body) +
                      other_method(tried_);
    status.converged = false;
    state            = best;
    return status;
  }

  Eigen::VectorXd DualContactSolver::newton_step(const Eigen::VectorXd &lambda) const
  {
    const AugmentedOperator &Q = *augmented_;
    const auto &[G, e]         = Q.constraint();
    Eigen::VectorXd gradient;
    Q.vmult(DualBlock::all, DualBlock::all, gradient, lambda);
    gradient -= Q.right_hand_side();
    const Eigen::MatrixXd forces =
      qp::sensitivity(Q.diagonal_block(DualBlock::all), G, lambda, gradient,
                      Q.nodal_compliance(), setting_.surface.slip_bound());
    // of motions that nothing resists just now the shortest step has none
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> system;
    system.setThreshold(unresisted);
    return system.compute(G.transpose() * forces).solve(e - G.transpose() * lambda);
  }

  void DualContactSolver::print_places(const State &state) const
  {
    const ObstacleMotion &motion = setting_.surface.motion();
    const Units units            = Units::named(setting_.parameters.output.units);
    std::vector<std::string> names; // said where there are several
    for (const ContactBoundary &boundary : setting_.surface.boundaries())
      if (boundary.force().norm() > 0.)
        names.push_back(setting_.surface.boundaries().size() > 1
                          ? " of boundary '" + boundary.name() + "'"
                          : "");
    const Eigen::VectorXd forces = motion.forces() - motion.missing_forces(state.lambda);
    for (Eigen::Index j = 0; j < forces.size(); ++j)
      print_progress("  obstacle" + names[j] + " moved by " +
                     with_unit(format("%.6g", state.distances(j)), units.length) +
                     " presses with " +
                     with_unit(format("%.6g", forces(j)), units.force));
  }

  void DualContactSolver::add_to(RunResult &result) const
  {
    DualMethodStatistics all = earlier_;
    if (method_) // there is none in a step to which nobody handed over
      all += method_->statistics();
    add_method(result.solver, all, present_operator());
    result.solver.dual_multiplications +=
      static_cast<unsigned long>(std::ceil(earlier_multiplications_));
    result.solver.stiffness_solves            = stiffness_solver_->n_solves();
    result.solver.stiffness_krylov_iterations = stiffness_solver_->n_iterations();
  }
} // namespace stiction
