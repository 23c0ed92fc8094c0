#pragma once

#include <stiction/simulation/warnings/warning.h>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;
  struct Units;

  /// Adds what linear kinematics leaves out of bodies: large strains and turns, moments
  /// that forces have where they come to, bodies that come into others of which
  /// nothing is said, and bodies that are pushed with nothing behind them. Collective.
  void add_warnings_of_bodies(const LinearElasticity &elasticity,
                              const ContactSurface &surface, const State &state,
                              const Units &units, bool has_steps, Warnings &warnings);
} // namespace stiction
