#pragma once

#include <stiction/base/units.h>
#include <stiction/elasticity/stiffness/support_reactions.h>
#include <stiction/qp/methods/dual_method.h>

#include <deal.II/base/tensor.h>

#include <nlohmann/json_fwd.hpp>

#include <mpi.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  class Body;
  class Certificate;
  class ContactConditions;
  struct ContactSolverParameters;
  class ContactSurface;
  class DualOperator;
  class NewtonMultigrid;
  struct OutputParameters;
  class ParameterFile;
  class Phases;
  struct MeshError;
  struct NodeStatus;
  struct SolveStatus;
  struct State;

  /// What a run found: summary.json and the report are made of it. Names are
  /// those of the file.
  struct RunResult
  {
    /// What the solver did.
    struct Solver : DualMethodStatistics
    {
      /// Of the Newton method in displacements. krylov_iterations are those on
      /// the mesh itself, the levels tell the others.
      struct Level
      {
        unsigned long dofs        = 0;
        unsigned int newton_steps = 0, krylov_iterations = 0;
        unsigned int factorized_from_step = 0; ///< 0: none
      };

      std::string law;
      std::string handed_over_to; ///< the method that went on, or was taken instead
      unsigned long dual_multiplications = 0;
      unsigned int stiffness_solves = 0, stiffness_krylov_iterations = 0;
      std::vector<Level> levels;
      unsigned int coarse_krylov_iterations = 0, rho_changes = 0;
      unsigned int elastic_solve_iterations = 0; ///< 0: not measured
      double elastic_solve_equivalents      = 0.;
    };

    /// A figure of the certificate.
    struct Figure
    {
      std::string name;
      double value;
      bool decides;
    };

    /// How many contact nodes are open, closed, undecided_normal and tied, which is
    /// all of them; how many slip, stick and are undecided_tangential, which is
    /// all at which friction may act; and how many are undecided in either.
    struct NodeCounts
    {
      unsigned int open = 0, closed = 0, undecided_normal = 0;
      unsigned int slip = 0, stick = 0, undecided_tangential = 0, tied = 0, undecided = 0;
    };

    /// What happens on the contact boundaries. Forces are those on the body,
    /// tangential_force the sum of the parts tangential to the contact surface;
    /// moments are about the origin, area is that of the closed nodes. Tension is
    /// what pulls at tied nodes along the normal, their traction that in any direction.
    /// Sums over all boundaries are without tied ones; the largest of what acts is not.
    /// max_mean_pressure is the largest pressure over the faces around a node.
    struct Contact : NodeCounts
    {
      double normal_force = 0., max_pressure = 0., max_mean_pressure = 0.;
      double max_tension       = 0.;
      double max_tied_traction = 0., area = 0.;
      dealii::Tensor<1, 3> force_on_body, tangential_force, moment;
    };

    /// What happens on one of them.
    struct ContactPart : Contact
    {
      std::string name;
      std::string title;        ///< ContactBoundary::title()
      std::string section_name; ///< NAME of the section 'Contact pair NAME'; ""
      std::string opposite; ///< of a pair, the boundary that bears the opposite force; ""
      unsigned int id = 0, nodes = 0;
      /// Of several that are opposite, the part of force_on_body that each exerts.
      std::vector<std::pair<std::string, dealii::Tensor<1, 3>>> of_opposite;
      dealii::Tensor<1, 3> obstacle_displacement, obstacle_rotation;
      double torque = 0.; ///< of friction on the body about the axis of the obstacle
    };

    /// Force on the body and moment about the origin of what holds a boundary.
    struct Support : SupportReactions::OnBoundary
    {
      std::string name;
      unsigned int id = 0;
    };

    /// The largest displacement of a node, and where.
    struct Displacement
    {
      double max = 0.;
      dealii::Tensor<1, 3> at;
    };

    /// At the answer, J.
    struct Energy
    {
      double strain = 0., load_work = 0., friction_dissipation = 0.;
    };

    /// The estimated error as a part of the energy norm of the displacement
    /// √(uᵀKu), whether it is from a sample, and of how many cells.
    struct RelativeMeshError
    {
      double relative_energy_error     = 0.;
      bool sampled                     = false;
      unsigned long long cells_sampled = 0; ///< 0: none was estimated
    };

    bool converged = false, interrupted = false;
    std::string reason; ///< if it is not certified: see explain()
    Units units;
    Solver solver;
    std::vector<Figure> certificate;
    double rounding = 0.;
    Contact contact; ///< without a body only counts and normal force
    std::map<std::string, std::optional<double>> seconds;
    double peak_memory_MB = 0.; ///< of all ranks together
    std::vector<std::string> warnings;

    bool has_body = false; ///< the rest is only there with one
    std::vector<ContactPart> boundaries;
    std::vector<Support> supports;
    std::vector<SupportReactions::AtPoint> points;
    Displacement displacement;
    Energy energy;
    RelativeMeshError mesh_error;
  };

  /// What there is of every run. Collective.
  RunResult result_of(const SolveStatus &solution, const ContactConditions &conditions,
                      const std::vector<NodeStatus> &statuses, double tolerance,
                      const OutputParameters &output, const Phases &phases,
                      MPI_Comm communicator);

  /// Enters what the dual method did, or the Newton method in displacements.
  void add_method(RunResult::Solver &solver, const DualMethodStatistics &method,
                  const DualOperator &Q);
  void add_method(RunResult::Solver &solver, const NewtonMultigrid &newton);

  /// Enters what is only there with a body. Collective.
  void add_body(RunResult &result, const Body &body, const ContactSurface &surface,
                const State &state, const Certificate &certificate,
                const std::vector<NodeStatus> &statuses,
                const SupportReactions &reactions, const MeshError &mesh_error);

  /// The content of summary.json but for what describes the problem.
  ///
  /// @param units the name of the units of all numbers.
  ///
  /// Collective.
  nlohmann::json to_json(const RunResult &result, const ContactSolverParameters &solver,
                         const std::string &units, const ParameterFile &source,
                         MPI_Comm communicator);
} // namespace stiction
