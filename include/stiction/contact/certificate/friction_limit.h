#pragma once

#include <set>
#include <vector>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct NodeStatus;
  struct RigidMotion;
  struct State;

  /// The bodies, by their places in Body::pieces(), that friction holds at its limit: of
  /// a body that contact alone holds no pressed node sticks, and they slip because it
  /// moves as a whole, along all that it touches. Then forces balance, but how far it
  /// goes is not determined. What moves, or belongs to several bodies at once, is taken
  /// to hold. Collective.
  ///
  /// @param motions those of all bodies as wholes, see
  /// LinearElasticity::free_motion_of().
  std::set<unsigned int> bodies_at_friction_limit(
    const LinearElasticity &elasticity, const ContactSurface &surface,
    const std::vector<RigidMotion> &motions, const State &state,
    const std::vector<NodeStatus> &statuses);
} // namespace stiction
