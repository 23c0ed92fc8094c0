#pragma once

#include <stiction/base/phases.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/certificate/error_estimator.h>
#include <stiction/contact/interface/state.h>
#include <stiction/output/history/step_result.h>
#include <stiction/simulation/checkpoint/mesh_history.h>
#include <stiction/simulation/discretization.h>
#include <stiction/simulation/warnings/warning.h>

#include <deal.II/base/timer.h>

#include <nlohmann/json_fwd.hpp>

#include <mpi.h>

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace stiction
{
  class AdaptiveRefinement;
  class Body;
  class CheckpointReader;
  class ContactSurface;
  class LinearElasticity;
  class Log;
  struct NodeStatus;
  struct RunResult;
  class Parameters;
  class SupportReactions;
  class ConvergenceHistory;
  class StepHistory;
  class TimeSteps;

  /// An elastic body in contact with a rigid foundation, from the parameters
  /// to the certified result and its files.
  class ContactProblem
  {
  public:
    /// The parameters must outlive the problem.
    ///
    /// @param restart the output directory of an earlier run, from whose checkpoint
    ///   this one goes on; empty: from the start.
    ContactProblem(const Parameters &parameters, MPI_Comm communicator,
                   const std::string &restart = "");
    ~ContactProblem();

    /// Solves the problem, on refined meshes again if that is wanted, certifies
    /// the answer and writes all files.
    /// Collective. Throws InputError, for bad input before anything is
    /// written, if a file cannot be written, and if an adaptive refinement makes a mesh
    /// of no use; then what was found on the one before is written.
    ///
    /// @return whether the certificate reached the tolerance; if not,
    ///   status() knows why.
    bool run();

    /// Makes mesh and contact surface, prints what they are, and solves and
    /// writes nothing. Throws InputError as run() would.
    void validate();

    /// The content of summary.json, after run().
    const nlohmann::json &summary() const { return *summary_; }

    const ContactSurface &contact_surface() const { return *discretization_->surface; }

    const LinearElasticity &elasticity() const { return *discretization_->elasticity; }

    /// What was found, how that ended, and what it is worth.
    const State &state() const { return state_; }
    const SolveStatus &status() const { return status_; }
    const Certificate &certificate() const { return *certificate_; }

    /// What the contact nodes do.
    std::vector<NodeStatus> node_statuses() const;

    /// The reactions of the supports.
    const SupportReactions &reactions() const { return *reactions_; }

  private:
    /// Solves the problem of the next time, on refined meshes again if that is
    /// wanted, and keeps the answer if it is certified; otherwise the step is cut.
    /// @return false if that would be too short, or the user wants no more.
    bool take_step(TimeSteps &times);
    /// Of several steps: from the body as it is made, or from the end of the last step.
    /// Leaves the problem at the time of that.
    void begin_balance();
    void solve_at(double time);

    /// As solve_at(). Where the input is of no use at that time, there is no answer, and
    /// the end of the last step stands. Throws InputError before the first one.
    void solve_or_refuse(double time);
    void begin_step(const TimeSteps &times);
    /// Makes the state the end of a step, and writes its results if there are several.
    void end_step(const TimeSteps &times);
    void record_step(const TimeSteps &times, const EnergyBalance::Step &energy);
    /// The files of the last step for ParaView.
    void write_step();
    /// Goes on from a checkpoint.
    void go_on(TimeSteps &times);
    /// Whether the run goes on in the directory in which it began. Collective.
    bool goes_on_in_place() const;
    /// Writes the checkpoint of the last step, unless there is one.
    void save(const TimeSteps &times);
    /// Says how to go on where steps are left.
    void explain_restart(const TimeSteps &times) const;
    /// From the end of the last step, in the direction of the last two if that
    /// fits the problem of this time better.
    State first_guess(double time) const;
    /// That at the end of the last step, nullptr before the first.
    const State *last_state() const
    {
      return ends_.empty() ? nullptr : &ends_.front().state;
    }
    /// Solves and certifies the problem of the present loads; obstacles along which
    /// bodies slide far are placed anew until the certificate holds with their gaps and
    /// normals at the answer itself.
    void solve_and_certify();
    /// Takes gaps and normals of these obstacles where body and obstacles are.
    void place_obstacles();
    /// The same with obstacles where they are placed; friction that depends on pressure
    /// or slip is followed until the certificate holds with its values at the answer
    /// itself.
    void solve_with_friction();
    void solve();
    /// What solves the problem on the present contact nodes, made where there is none.
    ContactSolver &solver();
    /// Makes the end of the last step what was reached, where nothing stops the body.
    void refuse_step(const std::string &reason);
    /// Adds what the solver did, in so many seconds, to that of the step.
    void add_effort(double seconds);
    void certify();
    /// The motions of bodies that contact hardly resists, in words.
    std::string hardly_resisted() const;
    void measure_duality_gap();
    /// Refines the mesh where the answer needs it.
    /// @return false if it is to remain as it is.
    bool refine_mesh();
    /// Cuts these cells and makes what lives on a mesh anew. After an InputError there
    /// is no discretization any more.
    void make_next_mesh(const std::vector<bool> &is_cut);

    /// Evaluates formulas at the times of all steps, of long histories as far as 20 s
    /// reach, so that validate() refuses them.
    void check_times();

    void make_grid();
    /// Of what was left to the program.
    void describe_choices() const;

    void describe_machine();
    void describe_body();

    /// Says what is applied, what of the parameter file is not, and what foundations
    /// under curved boundaries are.
    void describe_applied() const;

    /// Warns of bodies that touch and do not feel one another.
    void describe_touching_bodies() const;

    /// Says how many contact nodes overlap their obstacles before the body gives way, or
    /// if all obstacles are far away.
    void describe_gaps();
    void assemble_system();
    void make_contact_surface();
    void open_output();
    /// Of an iteration. Ends it by an exception if the user wants that.
    void observe(const ContactStep &iteration);
    void estimate_mesh();
    void measure_reference_costs();
    void output_results();
    /// The nodal forces of contact on the body, N.
    LA::Vector contact_force() const;
    void compute_reactions();
    /// The files of what was found, with this behind the words of their names.
    void write_fields(const std::string &tag) const;
    void export_problem();
    /// What the certificate of a step does not see. Collective.
    std::vector<Warning> warnings_of_step() const;
    /// Keeps those of a step that ends. Collective.
    void remember_warnings();
    /// Those of the last step in sentences, and of earlier ones the worst of what they
    /// alone are about. Collective.
    std::vector<std::string> warnings() const;
    RunResult result() const;
    /// Writes summary.json.
    void summarize(const RunResult &result);
    /// Writes summary.json and prints the report.
    void report();
    /// The list "steps" of summary.json.
    nlohmann::json step_list() const;
    /// Of all steps.
    void print_totals() const;
    /// "output/solution.pvtu and output/contact.pvtu in ParaView."
    std::string files_to_open() const;

    const Parameters &parameters_;
    const MPI_Comm communicator_;
    const Units units_;

    std::unique_ptr<Log> log_;
    std::unique_ptr<ConvergenceHistory> history_;
    std::unique_ptr<AdaptiveRefinement> refinement_; ///< if it is wanted
    std::unique_ptr<Body> body_;
    std::unique_ptr<Discretization> discretization_;
    State state_;
    /// Ends of the last steps, the last one first, or the start; on the present mesh.
    std::deque<StepEnd> ends_;
    MeshHistory mesh_history_;
    /// What the run goes on from, if it is no new one.
    std::unique_ptr<CheckpointReader> restart_;
    unsigned int n_steps_saved_ = 0; ///< those before the last checkpoint
    SolveStatus status_;
    bool ends_between_steps_ = false; ///< interrupted after a certified step
    std::unique_ptr<Certificate> certificate_;

    /// Of the certified steps of this run, by what they are about.
    std::map<std::string, Warning> warned_;

    std::unique_ptr<StepHistory> steps_;     ///< if there are several, here or before
    std::unique_ptr<EnergyBalance> balance_; ///< of these steps
    SolverEffort effort_;                    ///< in this step
    SolverEffort counted_;           ///< of the present solver before the last solve
    dealii::Timer since_first_step_; ///< of this run

    std::unique_ptr<SupportReactions> reactions_;
    MeshError mesh_error_; ///< of no cells: not estimated

    std::unique_ptr<nlohmann::json> summary_;

    bool is_step_written_ = true;  ///< whether the last step has its files
    bool has_output_      = false; ///< whether open_output() was called
    Phases phases_;
    /// Iterations of one elastic solve, if it was measured.
    unsigned int elastic_solve_iterations_ = 0;
  };
} // namespace stiction
