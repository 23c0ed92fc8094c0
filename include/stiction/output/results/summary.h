#ifndef stiction_output_results_summary_h
#define stiction_output_results_summary_h

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/qp/sets/slip_bound.h>

#include <nlohmann/json_fwd.hpp>

#include <mpi.h>

#include <string>
#include <vector>

namespace stiction
{
  class Certificate;
  class ContactConditions;
  class ContactSurface;
  class DualMethod;
  class DualOperator;
  struct ContactSolverParameters;
  class LinearElasticity;
  class MeshNames;
  class NewtonMultigrid;
  class Parameters;
  class SupportReactions;
  struct MeshError;
  struct NodeStatus;
  struct SolveStatus;
  struct State;

  /// The section "certificate" of summary.json; the figures that only a body
  /// has are null without one.
  nlohmann::json certificate_to_json(const ContactConditions &conditions);

  /// Entries of the section "contact": how many nodes are "open", "closed" and
  /// "undecided_normal", which is all of them; how many "slip", "stick" and are
  /// "undecided_tangential", which is all at which friction may act; and how
  /// many are "undecided" in either.
  nlohmann::json counts_to_json(const std::vector<NodeStatus> &statuses);

  /// What summary.json begins with, whatever was solved: the program, how it
  /// ended, units and input.
  nlohmann::json head_of_summary(const SolveStatus &solution,
                                 const Parameters &parameters, MPI_Comm communicator);

  /// What the section "solver" says of the dual method.
  nlohmann::json solver_to_json(const ContactSolverParameters &parameters,
                                const qp::SlipBound &slip_bound, const DualMethod &method,
                                const DualOperator &Q);

  /// The same for the Newton method in displacements. krylov_iterations are
  /// those on the mesh itself, the levels tell the others.
  nlohmann::json solver_to_json(const ContactSolverParameters &parameters,
                                const NewtonMultigrid &newton);

  /// The sections "contact" and "energy", from a certificate. Forces are those
  /// on the body, tangential_force the sum of the parts tangential to the
  /// contact surface; moments are about the origin, area is that of the closed
  /// nodes. Each contact boundary has
  /// an entry in "boundaries" with the same figures.
  nlohmann::json contact_to_json(const ContactSurface &surface, const State &state,
                                 const Certificate &certificate,
                                 const std::vector<NodeStatus> &statuses);
  nlohmann::json energy_to_json(const ContactSurface &surface,
                                const Certificate &certificate);

  /// The section "reactions": forces of the supports on the body, and their
  /// moments about the origin.
  nlohmann::json reactions_to_json(const SupportReactions &reactions,
                                   const MeshNames &names);

  /// The boundaries of the mesh with their ids and names; those without a name
  /// have their id for one.
  nlohmann::json boundaries_to_json(const MeshNames &names);

  /// The section "units": what 'Output/Units' says, empty for none.
  nlohmann::json units_to_json(const std::string &name);

  /// The section "mesh_error": the estimated error as a part of the energy norm
  /// of the displacement √(uᵀKu), whether it is from a sample, and of how many
  /// cells; null if none was estimated.
  nlohmann::json mesh_error_to_json(const MeshError &error, double strain_energy);

  /// The section "displacement": the largest displacement of a node, and
  /// where. Collective.
  nlohmann::json displacement_to_json(const LinearElasticity &elasticity,
                                      const LA::Vector &u);
} // namespace stiction

#endif
