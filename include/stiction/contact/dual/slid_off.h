#pragma once

#include <functional>
#include <string>

namespace stiction
{
  class ContactBoundary;
  class ContactSurface;
  class LinearElasticity;
  struct State;
  struct Units;

  /// The part of the strain energy of the bodies of a pair that is from facets.
  using ShareOfFacets = std::function<double(const ContactBoundary &pair)>;

  /// Which pressed surface of a body slid on another body, though nothing drives it
  /// there, by more than all bodies are large together, or until facets wedged, in words;
  /// empty if none did. The discrete problem may have such an answer: facets stop what
  /// friction does not hold. Collective.
  std::string why_slid_off(const LinearElasticity &elasticity,
                           const ContactSurface &surface, const State &state,
                           const ShareOfFacets &share_of_facets, const Units &units);
} // namespace stiction
