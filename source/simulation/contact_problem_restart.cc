// How a problem is taken from one run to the next.

#include <stiction/base/log.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/output/history/step_history.h>
#include <stiction/simulation/checkpoint/checkpoint.h>
#include <stiction/simulation/checkpoint/problem_identity.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/time_steps.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <string>
#include <utility>

namespace stiction
{
  bool ContactProblem::goes_on_in_place() const
  {
    std::error_code none; // a directory that is not there yet is another one
    const bool is_same =
      restart_ && std::filesystem::equivalent(restart_->output_directory(),
                                              parameters_.output.directory, none);
    return dealii::Utilities::MPI::broadcast(communicator_, is_same);
  }

  void ContactProblem::go_on(TimeSteps &times)
  {
    if (!restart_)
      return;
    Checkpoint checkpoint = restart_->read(elasticity());
    times.go_on_from(checkpoint.steps);
    const std::string last =
      parameters_.source.given().count("Time/End") > 0 || !parameters_.time.has_steps()
        ? "Time/End"
        : "Time/Steps";
    parameters_.source.require(
      !times.is_finished(), last,
      format("must go on after t = %.6g, which the checkpoint ", times.reached()) +
        restart_->directory() + " has reached");
    const auto n_pressed = checkpoint.ends.front().state.distances.size();
    parameters_.source.require(contact_surface().motion().n_pressed() == n_pressed,
                               "Boundary conditions/Obstacle force",
                               "must press on as many obstacles as in the checkpoint " +
                                 restart_->directory() + ", " +
                                 std::to_string(n_pressed));
    require_same_sides(contact_surface(), checkpoint.slave_sides, restart_->directory());
    ends_               = std::move(checkpoint.ends);
    const bool in_place = goes_on_in_place();
    steps_->go_on_from(checkpoint.history, in_place);
    if (in_place)
      n_steps_saved_ = times.n_taken();
    log_->line(format("Going on after step %u, t = %.6g, from ", times.n_taken(),
                      times.reached()) +
               restart_->directory());
  }

  void ContactProblem::save(const TimeSteps &times)
  {
    if (parameters_.time.checkpoint_every == 0 || times.n_taken() == n_steps_saved_)
      return;
    const auto phase = phases_.scope("output");
    write_checkpoint(
      parameters_.output.directory,
      {times.progress(), steps_->progress(), ends_, slave_sides(contact_surface())},
      mesh_history_, elasticity(), parameters_);
    n_steps_saved_ = times.n_taken();
  }

  void ContactProblem::explain_restart(const TimeSteps &times) const
  {
    if (parameters_.time.checkpoint_every == 0 || times.is_finished() || ends_.empty())
      return;
    log_->line(
      format("The checkpoint is of t = %.6g; go on with the same command and --restart ",
             times.reached()) +
      parameters_.output.directory);
  }
} // namespace stiction
