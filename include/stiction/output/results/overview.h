#pragma once

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  class Log;
  struct Units;

  /// Prints what is applied where, as the entries say it and the program
  /// understands it: what is held or moved, loads with their resultants,
  /// contact boundaries, materials. Collective.
  void print_applied(Log &log, const LinearElasticity &elasticity,
                     const ContactSurface &surface);

  /// Prints what else a user wants to see before solving: the size of the body,
  /// its boundaries with their names, areas, supports and load resultants, and
  /// the contact boundaries with their initial gaps. Collective.
  void print_overview(Log &log, const LinearElasticity &elasticity,
                      const ContactSurface &surface, const Units &units);
} // namespace stiction
