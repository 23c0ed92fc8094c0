#pragma once

#include <stiction/simulation/warnings/warning.h>

namespace stiction
{
  class Body;
  class Certificate;
  class ContactBoundary;
  class ContactSurface;
  struct PairFigures;
  struct Units;

  /// The part of the strain energy of both bodies that is from facets, see
  /// climbed_facets().
  double share_of_facets(const ContactBoundary &pair, const PairFigures &figures,
                         const Body &body, const Certificate &certificate);

  /// Adds what the certificate does not tell of a pair: tractions that waver and, if it
  /// is not tied, overlaps, forces beyond edges, ways, gaps, tilt, joints and facets.
  ///
  /// @param way by which elastic bodies give, m.
  void add_warnings_of_pair(const ContactBoundary &pair, const ContactSurface &surface,
                            const PairFigures &figures, const Body &body,
                            const Certificate &certificate, double way,
                            const Units &units, Warnings &warnings);
} // namespace stiction
