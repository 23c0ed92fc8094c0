// How a problem is taken from time to time, and in each step from mesh to mesh.

#include <stiction/base/errors.h>
#include <stiction/base/interrupt.h>
#include <stiction/base/log.h>
#include <stiction/base/text/in_words.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/dual/no_equilibrium.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/history/step_history.h>
#include <stiction/output/results/convergence_history.h>
#include <stiction/output/results/report.h>
#include <stiction/output/results/run_result.h>
#include <stiction/simulation/adaptive_refinement.h>
#include <stiction/simulation/checkpoint/carried_state.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/time_steps.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
    // Seconds: who waits for less needs no forecast.
    constexpr double worth_a_forecast = 20.;

    // A guess is in balance if its equilibrium residual is below this.
    constexpr double balanced = 1e-6;

    // Before any load, from where the second step is extrapolated.
    State at_rest(State state)
    {
      state.u = 0.;
      state.lambda.setZero();
      state.distances.setZero();
      return state;
    }
  } // namespace

  bool ContactProblem::take_step(TimeSteps &times)
  {
    // a step that begins at its solution has no iteration that would notice it
    if (certificate_ && is_interrupted(communicator_))
      {
        status_.converged   = false;
        status_.interrupted = true;
        ends_between_steps_ = true;
        return false;
      }
    begin_step(times);
    solve_or_refuse(times.time());
    while (refine_mesh())
      solve_or_refuse(times.time());
    if (status_.converged)
      {
        times.accept();
        end_step(times);
        const unsigned int every = parameters_.time.checkpoint_every;
        if (every > 0 && times.n_taken() % every == 0)
          save(times);
        return true;
      }
    if (status_.interrupted || !times.cut())
      return false;
    if (parameters_.output.print_progress)
      log_->line("The step is taken back: " +
                 explain(status_, *certificate_, parameters_.contact_solver.tolerance));
    if (ends_.empty())
      state_ = {{}, {}, {}, {}}; // it may be of other contact nodes
    return true;
  }

  void ContactProblem::begin_balance()
  {
    if (!steps_)
      return;
    discretization_->set_time(parameters_.of_contact(),
                              ends_.empty() ? parameters_.time.start : ends_.front().time,
                              {}, last_state());
    if (ends_.empty())
      balance_ = std::make_unique<EnergyBalance>(elasticity(), contact_surface());
    else
      balance_ = std::make_unique<EnergyBalance>(
        elasticity(), contact_surface(), ends_.front().state,
        balance_ ? std::optional(balance_->elastic_energy()) : std::nullopt);
  }

  void ContactProblem::begin_step(const TimeSteps &times)
  {
    if (parameters_.refinement.adaptive_steps > 0)
      refinement_ = std::make_unique<AdaptiveRefinement>(parameters_);
    if (!steps_)
      return;
    history_->begin_time(times.time());
    effort_           = {};
    const double done = times.part_done();
    if (done == 0.)
      since_first_step_.restart();
    const double seconds = since_first_step_.wall_time();
    if (parameters_.output.print_progress)
      log_->line(format("Step %u: t = %.6g to %.6g", times.n_taken() + 1, times.reached(),
                        times.time()) +
                 (done > 0. && seconds > worth_a_forecast
                    ? format(", after %.0f s and %.0f %% of the time; at this pace %.0f "
                             "s are left",
                             seconds, 100. * done, seconds * (1. / done - 1.))
                    : ""));
  }

  void ContactProblem::solve_or_refuse(const double time)
  {
    try
      {
        solve_at(time);
      }
    catch (const InputError &error)
      {
        if (ends_.empty())
          throw;
        const StepEnd &last = ends_.front();
        discretization_->set_time(parameters_.of_contact(), last.time, last.state.history,
                                  last_state());
        refuse_step(format("the input is of no use at t = %.6g: ", time) +
                    without_full_stop(error.what()) +
                    format("; shown is the end of the step before, t = %.6g", last.time));
      }
  }

  void ContactProblem::solve_at(const double time)
  {
    const SlipHistory history =
      ends_.empty() ? SlipHistory() : ends_.front().state.history;
    discretization_->set_time(parameters_.of_contact(), time, history, last_state());
    if (steps_) // else it was asked when the surface was made
      if (const std::string reason =
            why_no_equilibrium(elasticity(), contact_surface(), units_);
          !reason.empty())
        return refuse_step(reason);
    if (!ends_.empty() &&
        ends_.front().state.distances.size() > contact_surface().motion().n_pressed())
      return refuse_step("'Boundary conditions/Obstacle force' becomes zero, which would "
                         "hold the obstacle where it is drawn, and may press harder "
                         "there, let a small force remain");
    if (!ends_.empty())
      state_ = first_guess(time);
    const SlipHistory here = on_nodes(history, contact_surface());
    const bool is_warm     = state_.lambda.size() > 0;
    const auto solve_from  = [&](State guess) {
      state_         = std::move(guess);
      state_.history = here;
      if (!ends_.empty())
        state_.scales = ends_.front().state.scales;
      solve_and_certify();
    };
    solve_from(state_);
    if (status_.converged || status_.interrupted || status_.slides || !is_warm)
      return;
    if (parameters_.output.print_progress)
      log_->line("It is solved once more, without what was known of it.");
    if (contact_surface().slides_far())
      discretization_->place_obstacles(parameters_.of_contact(), history, nullptr);
    solve_from({{}, {}, state_.distances, {}});
  }

  void ContactProblem::refuse_step(const std::string &reason)
  {
    const ContactSurface &surface = contact_surface();
    open_output();
    state_  = ends_.empty() ? State{elasticity().zero_vector(),
                                   Eigen::VectorXd::Zero(3 * surface.n_nodes()),
                                   Eigen::VectorXd::Zero(surface.motion().n_pressed()),
                                   {}}
                            : ends_.front().state;
    status_ = {};
    certify();
    status_ = {false, reason};
  }

  void ContactProblem::add_effort(const double seconds)
  {
    RunResult all; // that the solver did so far
    discretization_->solver->add_to(all);
    const RunResult::Solver &now = all.solver;
    effort_.newton_steps += now.newton_steps - counted_.newton_steps;
    effort_.krylov_iterations += now.krylov_iterations - counted_.krylov_iterations;
    effort_.dual_multiplications +=
      now.dual_multiplications - counted_.dual_multiplications;
    effort_.seconds += seconds;
    counted_ = {now.newton_steps, now.krylov_iterations, now.dual_multiplications, 0.};
  }

  State ContactProblem::first_guess(const double time) const
  {
    const auto &[last_time, last]       = ends_.front();
    const auto &[earlier_time, earlier] = ends_.back();
    // a force that begins or ends to press makes an obstacle another one
    if (last.distances.size() != contact_surface().motion().n_pressed())
      return {{}, {}, {}, {}};
    // where an obstacle made others contact nodes their forces are no guess
    if (on_nodes(last.history, contact_surface()).nodes != last.history.nodes)
      return {{}, {}, last.distances, {}};
    if (ends_.size() < 2 || earlier.history.nodes != last.history.nodes ||
        earlier.distances.size() != last.distances.size())
      return last;
    const double ratio = (time - last_time) / (last_time - earlier_time);
    State further      = last;
    further.u.sadd(1. + ratio, -ratio, earlier.u);
    further.lambda += ratio * (last.lambda - earlier.lambda);
    further.distances += ratio * (last.distances - earlier.distances);

    // Forces beyond their bounds tell which nodes will slip or open, and are no error of
    // the guess; loads or supports that turned leave nodes inside, or pressed obstacles,
    // out of balance, and obstacles that did leave gaps where nodes are pressed.
    struct Errors
    {
      double force_scale, imbalance, obstacle_force, gap; // N, N, of itself, m
    };
    const auto errors_of = [this](State state) -> Errors {
      elasticity().prescribe(state.u);
      const Certificate certificate(elasticity(), contact_surface(), state);
      const Eigen::VectorXd pressing =
        state.lambda.head(contact_surface().n_nodes()).cwiseMax(0.);
      const double gaps =
        pressing.dot(certificate.gradient().head(pressing.size()).cwiseAbs());
      const Certificate::BodyFigures &figures = certificate.body_figures();
      return {certificate.force_scale(),
              figures.equilibrium_residual * certificate.force_scale(),
              figures.obstacle_force, gaps > 0. ? gaps / pressing.sum() : 0.};
    };
    const Errors of_last = errors_of(last), of_further = errors_of(further);
    const bool is_nearer =
      of_further.imbalance <=
        std::max(balanced * of_further.force_scale, of_last.imbalance) &&
      of_further.obstacle_force <= std::max(balanced, of_last.obstacle_force) &&
      of_further.gap <= std::max(balanced * further.u.linfty_norm(), of_last.gap);
    return is_nearer ? further : last;
  }

  void ContactProblem::end_step(const TimeSteps &times)
  {
    state_.history = history_after(state_, contact_surface());
    remember_warnings();
    if (!certificate_->bears_nothing())
      state_.scales = {std::max(state_.scales.force, certificate_->force_scale()),
                       std::max(state_.scales.energy, certificate_->energy_scale())};
    if (ends_.empty() && steps_ && parameters_.time.start < times.reached())
      ends_.push_front({parameters_.time.start, at_rest(state_)});
    ends_.push_front({times.reached(), state_});
    ends_.resize(std::min<std::size_t>(ends_.size(), 2));
    if (steps_)
      record_step(times, balance_->add_step(elasticity(), contact_surface(), state_));
  }

  bool ContactProblem::refine_mesh()
  {
    if (!refinement_)
      return false;
    std::vector<bool> is_cut;
    {
      const auto phase = phases_.scope("error_estimate");
      refinement_->add_mesh(elasticity(), contact_surface(), status_.converged, state_,
                            certificate_->strain_energy());
      is_cut = refinement_->cells_to_cut(elasticity(), contact_surface());
    }
    log_->line(refinement_->remark());
    if (refinement_->is_finished())
      return false;
    if (is_interrupted(communicator_))
      {
        status_.interrupted = true;
        log_->line("INTERRUPTED: the mesh is refined no further.");
        return false;
      }

    if (!steps_)
      {
        estimate_mesh();
        output_results();
        summarize(result());
      }
    try
      {
        make_next_mesh(is_cut);
      }
    catch (const InputError &error)
      {
        log_->line(std::string("The next mesh is of no use: ") + error.what());
        if (!steps_)
          log_->line("The results of this one are in " + parameters_.output.directory +
                     ".");
        throw;
      }
    return true;
  }

  void ContactProblem::make_next_mesh(const std::vector<bool> &is_cut)
  {
    // The end of the last step or, without steps, the answer, to begin with. With
    // 'Sliding = far' frames are those of the answer, which is not known there.
    std::optional<CarriedState> carried;
    if (!steps_ && status_.converged && !contact_surface().slides_far())
      carried.emplace(state_, elasticity(), contact_surface());
    else if (!ends_.empty())
      {
        // on the contact nodes and in the frames of that end
        discretization_->solver.reset();
        discretization_->set_time(parameters_.of_contact(), ends_.front().time,
                                  ends_.front().state.history, last_state());
        carried.emplace(ends_.front().state, elasticity(), contact_surface());
      }
    discretization_.reset();
    // where obstacles are is no matter of the mesh
    state_ = {{}, {}, state_.distances, {}};
    {
      const auto phase = phases_.scope("mesh");
      mesh_history_.add(is_cut, *body_);
      body_->refine(is_cut, carried ? carried->fields() : std::vector<LA::Vector *>());
      describe_body();
    }
    history_->begin_mesh();
    assemble_system();
    make_contact_surface();
    if (carried && !steps_)
      state_ = carried->on(elasticity(), contact_surface());
    else if (carried)
      {
        const double time = ends_.front().time;
        discretization_->set_time(parameters_.of_contact(), time, {});
        State state = carried->on(elasticity(), contact_surface());
        if (contact_surface().slides_far())
          {
            discretization_->place_obstacles(parameters_.of_contact(), {}, &state);
            state = carried->on(elasticity(), contact_surface());
          }
        state.scales = ends_.front().state.scales;
        ends_        = {{time, std::move(state)}};
      }
    begin_balance();
  }
} // namespace stiction
