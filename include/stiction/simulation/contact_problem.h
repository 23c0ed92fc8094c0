#ifndef stiction_simulation_contact_problem_h
#define stiction_simulation_contact_problem_h

#include <stiction/base/phases.h>
#include <stiction/contact/certificate/body_verifier.h>
#include <stiction/contact/certificate/error_estimator.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/qp/certified_solve.h>

#include <nlohmann/json_fwd.hpp>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace stiction
{
  class AdaptiveRefinement;
  class Body;
  class ContactSurface;
  class DualMethod;
  class DualOperator;
  class ForceControl;

  class LinearElasticity;
  class Log;
  class NewtonMultigrid;
  struct NodeStatus;
  class Parameters;
  class StiffnessSolver;
  class SupportReactions;
  class ConvergenceHistory;

  /// An elastic body in contact with a rigid foundation, from the parameters
  /// to the certified result and its files.
  class ContactProblem
  {
  public:
    /// The parameters must outlive the problem.
    ContactProblem(const Parameters &parameters, MPI_Comm communicator);
    ~ContactProblem();

    /// Solves the problem, on refined meshes again if that is wanted, certifies
    /// the answer and writes all files.
    /// Collective. Throws InputError, for bad input before anything is
    /// written, and if a file cannot be written.
    ///
    /// @return whether the certificate reached the tolerance; if not,
    ///   solution() knows why.
    bool
    run();

    /// Makes mesh and contact surface, prints what they are, and solves and
    /// writes nothing. Throws InputError as run() would.
    void
    validate();

    /// The content of summary.json, after run().
    const nlohmann::json &
    summary() const
    {
      return *summary_;
    }

    const ContactSurface &
    contact_surface() const
    {
      return *surface_;
    }

    const LinearElasticity &
    elasticity() const
    {
      return *elasticity_;
    }

    const ContactSolution &
    solution() const
    {
      return *solution_;
    }

    /// The displacement of the solution (m) and its certificate.
    const LA::Vector &
    displacement() const
    {
      return verifier_->displacement();
    }
    const Certificate &
    certificate() const
    {
      return verifier_->certificate();
    }

    /// What the contact nodes do.
    std::vector<NodeStatus>
    node_statuses() const;

    /// The reactions of the supports.
    const SupportReactions &
    reactions() const
    {
      return *reactions_;
    }

  private:
    void
    solve_and_certify();
    /// Refines the mesh where the answer needs it, and forgets what was made
    /// on it. @return false if it is to remain as it is.
    bool
    refine_mesh();

    void
    make_grid();
    /// Of what was left to the program.
    void
    describe_choices() const;

    void
    describe_machine();
    void
    describe_body();
    void
    assemble_system();
    void
    make_contact_surface();
    /// Prepares the search for the places of pressed obstacles.
    void
    control_forces();
    void
    open_output();
    void
    set_up_stiffness_solver();
    void
    set_up_dual_operator();
    void
    solve_for_contact_forces();
    /// What to choose where the method comes no closer.
    std::string
    other_method() const;
    void
    set_up_multigrid();
    void
    solve_for_displacements();
    /// Ends the iteration by an exception if the user wants it.
    void
    finish_step(const ContactStep &step);
    void
    certify();
    void
    verify_displacement();
    void
    compute_duality_gap();
    void
    estimate_mesh();
    void
    measure_reference_costs();
    void
    output_results();
    void
    export_problem();
    void
    summarize();
    /// What the certificate does not see, in sentences.
    std::vector<std::string>
    warnings() const;
    void
    report() const;

    const Parameters &parameters_;
    const MPI_Comm communicator_;

    std::unique_ptr<Log> log_;
    std::unique_ptr<ConvergenceHistory> history_;
    std::unique_ptr<AdaptiveRefinement> refinement_; ///< if it is wanted
    std::unique_ptr<Body> body_;
    std::unique_ptr<LinearElasticity> elasticity_;
    std::unique_ptr<ContactSurface> surface_;
    std::unique_ptr<ForceControl> force_control_; ///< if a force is prescribed
    std::unique_ptr<StiffnessSolver> stiffness_solver_;
    std::unique_ptr<DualOperator> schur_;
    std::unique_ptr<DualMethod> method_;
    std::unique_ptr<NewtonMultigrid> newton_;
    std::unique_ptr<BodyVerifier> verifier_;
    std::unique_ptr<ContactSolution> solution_;

    std::unique_ptr<SupportReactions> reactions_;
    MeshError mesh_error_; ///< of no cells: not estimated

    std::unique_ptr<nlohmann::json> summary_;

    bool has_output_ = false; ///< whether open_output() was called
    Phases phases_;
    /// Iterations of one elastic solve, if it was measured.
    unsigned int elastic_solve_iterations_ = 0;
  };
} // namespace stiction

#endif
