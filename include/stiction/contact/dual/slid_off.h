#pragma once

#include <string>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;
  struct Units;

  /// Which pressed surface of a body slid on another body by more than all bodies are
  /// large together, though nothing drives it there, in words; empty if none did. The
  /// discrete problem may have such an answer: facets stop what friction does not hold.
  /// Collective.
  std::string why_slid_off(const LinearElasticity &elasticity,
                           const ContactSurface &surface, const State &state,
                           const Units &units);
} // namespace stiction
