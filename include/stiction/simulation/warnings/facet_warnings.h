#pragma once

#include <stiction/simulation/warnings/warning.h>

namespace stiction
{
  class Body;
  class ContactSurface;
  struct State;
  struct Units;

  /// Warns of contact boundaries whose nodes, or those opposite, lie on facets in place
  /// of the round surface that these stand for, as refinement leaves them in a mesh from
  /// a file, and what cuts its triangles: where forces act, by more than a twentieth of
  /// what bodies give. Collective.
  ///
  /// @param way what bodies give, m.
  void add_warnings_of_facets(const Body &body, const ContactSurface &surface,
                              const State &state, double way, const Units &units,
                              Warnings &warnings);
} // namespace stiction
