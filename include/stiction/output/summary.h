#ifndef stiction_output_summary_h
#define stiction_output_summary_h

#include <stiction/elasticity/linear_algebra.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace stiction
{
  class Certificate;
  class ContactSurface;
  class LinearElasticity;

  /// The sections "contact", "certificate" and "energy" of summary.json, from
  /// a certificate. Forces in N, moments in Nm, pressures in Pa, areas in m²,
  /// energies in J.
  nlohmann::json
  certificate_to_json(const Certificate &certificate);
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
