#ifndef stiction_output_summary_h
#define stiction_output_summary_h

#include <stiction/elasticity/linear_algebra.h>
#include <stiction/qp/slip_bound.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace stiction
{
  class Certificate;
  class ContactConditions;
  class ContactSurface;
  class DualMethod;
  class DualOperator;
  struct ContactSolverParameters;
  class LinearElasticity;
  class NewtonMultigrid;

  /// The section "certificate" of summary.json; the figures that only a body
  /// has are null without one.
  nlohmann::json
  certificate_to_json(const ContactConditions &conditions);

  /// The entries "open", "slip", "stick" and "undecided" of the section
  /// "contact".
  nlohmann::json
  counts_to_json(const ContactConditions &conditions, double tolerance);

  /// What the section "solver" says of the dual method.
  nlohmann::json
  solver_to_json(const ContactSolverParameters &parameters,
                 const qp::SlipBound &slip_bound,
                 const DualMethod &method,
                 const DualOperator &Q);

  /// The same for the Newton method in displacements. krylov_iterations are
  /// those on the mesh itself, the levels tell the others.
  nlohmann::json
  solver_to_json(const ContactSolverParameters &parameters,
                 const NewtonMultigrid &newton);

  /// The sections "contact" and "energy", from a certificate. Forces in N,
  /// moments in Nm, pressures in Pa, areas in m², energies in J. Several
  /// contact boundaries have an entry each in "boundaries".
  nlohmann::json
  contact_to_json(const ContactSurface &surface,
                  const Certificate &certificate,
                  double tolerance);
  nlohmann::json
  energy_to_json(const ContactSurface &surface, const Certificate &certificate);

  /// The section "displacement": the largest displacement of a node in m, and
  /// where. Collective.
  nlohmann::json
  displacement_to_json(const LinearElasticity &elasticity, const LA::Vector &u);
} // namespace stiction

#endif
