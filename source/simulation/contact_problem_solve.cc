// How a problem is solved at one time on one mesh, and certified.

#include <stiction/base/errors.h>
#include <stiction/base/log.h>
#include <stiction/base/text/in_words.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/certificate/pair_figures.h>
#include <stiction/contact/dual/hardly_resisted.h>
#include <stiction/contact/dual/no_equilibrium.h>
#include <stiction/contact/dual/rigid_balance.h>
#include <stiction/contact/dual/slid_off.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/solvers/componentwise_secant.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/warnings/pair_warnings.h>

#include <deal.II/base/timer.h>

#include <limits>
#include <string>
#include <utility>

namespace stiction
{
  namespace
  {
    // The coefficients of friction are taken anew from the last answer so often: a
    // residual that falls by 0.8 each time is below 1e-9 by then.
    constexpr unsigned int max_approximations = 100;

    // Obstacles are placed at the last answer so often. What is left falls each time by
    // what forces change as normals turn: by a hundred and more on bodies that are
    // pressed in by little, by two on those that are by a part of a radius.
    constexpr unsigned int max_placements = 40;

    // Where the equilibrium lacks more, no pressures were reached that tell of friction.
    constexpr double in_equilibrium = 1e-2;
  } // namespace

  void ContactProblem::solve_and_certify()
  {
    solve_with_friction();
    if (!contact_surface().slides_far())
      return;
    for (unsigned int k = 1; status_.converged; ++k)
      {
        try
          {
            place_obstacles();
          }
        catch (const InputError &error)
          {
            status_.converged = false;
            status_.reason    = "obstacles cannot be placed at the answer: " +
                             without_full_stop(error.what());
            return;
          }
        certify();
        if (status_.converged)
          return;
        const double error = certificate_->worst_figure().second;
        if (k == max_placements)
          {
            status_.reason =
              format("obstacles with 'Sliding = far' do not settle: placed %u times at "
                     "the answer they leave a residual of %.2g, take smaller steps "
                     "('Time/Steps') or a smoother obstacle",
                     k, error);
            return;
          }
        if (parameters_.output.print_progress)
          log_->line(
            format("Obstacles at the answer, placement %u: residual %.2e", k, error));
        solve_with_friction();
      }
  }

  void ContactProblem::place_obstacles()
  {
    const auto phase = phases_.scope("contact_surface");
    const SlipHistory history =
      ends_.empty() ? SlipHistory() : ends_.front().state.history;
    ContactSurface &surface = *discretization_->surface;
    const ContactSurface before =
      discretization_->place_obstacles(parameters_.of_contact(), history, &state_);
    state_.lambda  = on_frames(state_.lambda, before, surface);
    state_.history = on_nodes(history, surface);
    if (surface.has_friction_of_state())
      surface.set_friction(state_.lambda, slip_path(state_, surface),
                           ContactSurface::FrictionForm::value);
  }

  ContactSolver &ContactProblem::solver()
  {
    auto &[elasticity, surface, solver] = *discretization_;
    if (!solver)
      {
        solver =
          ContactSolver::create({parameters_, *elasticity, *surface, *log_, phases_});
        counted_ = {};
      }
    return *solver;
  }

  void ContactProblem::solve()
  {
    const auto phase = phases_.scope("contact_solve");
    const dealii::Timer timer;
    const auto &elasticity = discretization_->elasticity;
    const auto &surface    = discretization_->surface;
    ContactSolver &method  = solver();
    open_output();
    state_.lambda = surface->without_dragged(std::move(state_.lambda));
    status_ =
      method.solve(state_, [&](const ContactStep &iteration) { observe(iteration); });
    leave_in_place(*elasticity, *surface,
                   ends_.empty() ? elasticity->zero_vector() : ends_.front().state.u,
                   parameters_.contact_solver.tolerance, state_);
    surface->add_friction_on_supports(state_, ends_.empty() ? Eigen::VectorXd()
                                                            : ends_.front().state.lambda);
    if (steps_)
      add_effort(timer.wall_time());
  }

  void ContactProblem::certify()
  {
    const auto phase = phases_.scope("certificate");
    certificate_ = std::make_unique<Certificate>(elasticity(), contact_surface(), state_);
    status_.converged = certificate_->converged(parameters_.contact_solver.tolerance);
    const bool is_too_deep =
      status_.converged && contact_surface().are_obstacles_too_deep(state_.distances);
    if (is_too_deep)
      status_ = {false,
                 "an obstacle would have to move by more than the body is large to "
                 "press with its force, lower 'Boundary conditions/Obstacle force' or "
                 "hold the body better",
                 status_.interrupted};
    if (status_.converged)
      {
        const auto of_facets = [&](const ContactBoundary &pair) {
          return share_of_facets(pair,
                                 pair_figures(elasticity(), contact_surface(), pair,
                                              state_, state_.scales.force),
                                 *body_, *certificate_);
        };
        const std::string slide =
          why_slid_off(elasticity(), contact_surface(), state_, of_facets, units_);
        if (!slide.empty())
          status_ = {false, slide, status_.interrupted, false, true};
        return;
      }
    if (status_.interrupted)
      return;
    const bool is_in_equilibrium =
      certificate_->body_figures().equilibrium_residual <= in_equilibrium;
    if (!is_in_equilibrium && !ends_.empty() &&
        on_nodes(ends_.front().state.history, contact_surface()).nodes ==
          ends_.front().state.history.nodes)
      if (const std::string motion = why_it_comes_out(elasticity(), contact_surface(),
                                                      ends_.front().state.lambda, units_);
          !motion.empty())
        {
          status_.reason = motion;
          return;
        }
    if (const std::string slide =
          why_it_slides(elasticity(), contact_surface(), *certificate_, units_);
        !slide.empty())
      {
        status_.reason = slide;
        status_.slides = is_in_equilibrium;
        return;
      }
    if (status_.reason.empty())
      status_.reason = "the certificate measures more than the iteration did, "
                       "raise 'Contact solver/Tolerance'";
    if (const std::string motion = hardly_resisted(); !motion.empty() && !is_too_deep)
      status_.reason += "; hardly anything resists where the body can " + motion +
                        ", see whether loads drive it there, and if they do not, hold it "
                        "with 'Boundary conditions/Prescribed points'";
  }

  std::string ContactProblem::hardly_resisted() const
  {
    const Eigen::MatrixXd motions =
      hardly_resisted_motions(elasticity(), contact_surface());
    return motions.cols() == 0 ? "" : elasticity().free_motions().in_words(motions);
  }

  void ContactProblem::solve_with_friction()
  {
    ContactSurface &surface = *discretization_->surface;
    if (!surface.has_friction_of_state())
      {
        solve();
        return certify();
      }
    double error = std::numeric_limits<double>::infinity(), contraction = 0.;
    qp::ComponentwiseSecant secant;
    Eigen::VectorXd path = slip_path(state_, surface);
    for (unsigned int k = 1; k <= max_approximations; ++k)
      {
        surface.set_friction(state_.lambda, path, ContactSurface::FrictionForm::tangent);
        if (discretization_->solver)
          discretization_->solver->update();
        solve();
        const bool is_solved             = status_.converged;
        const Eigen::VectorXd path_there = slip_path(state_, surface);
        surface.set_friction(state_.lambda, path_there,
                             ContactSurface::FrictionForm::value);
        certify();
        const double last = std::exchange(error, certificate_->worst_figure().second);
        contraction       = error / last;
        if (parameters_.output.print_progress)
          log_->line(
            format("Friction at the answer, approximation %u: residual %.2e", k, error) +
            (k > 1 ? format(", contraction %.2g", contraction) : ""));
        if (status_.converged || status_.interrupted || !is_solved)
          return;
        path = secant.next(path, path_there);
        if (state_.history.path.size() > 0)
          path = path.cwiseMax(state_.history.path);
        else
          path = path.cwiseMax(0.);
      }
    status_.reason =
      format("friction that depends on pressure or slip does not settle (the last "
             "approximation changed the residual by a factor of %.2g), let the formula "
             "change more gently: where friction falls faster with slip than the body "
             "springs back, the body jumps and there is no answer nearby",
             contraction);
  }
} // namespace stiction
