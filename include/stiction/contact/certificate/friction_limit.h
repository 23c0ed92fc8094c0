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
  /// @param tolerance of forces, beside pressures.
  std::set<unsigned int> bodies_at_friction_limit(const LinearElasticity &elasticity,
                                                  const ContactSurface &surface,
                                                  const std::vector<RigidMotion> &motions,
                                                  const State &state,
                                                  const std::vector<NodeStatus> &statuses,
                                                  double tolerance);

  /// The part of the normal force of each contact boundary that nodes bear which
  /// supports hold in a direction, in which no friction acts, and along which they have
  /// slipped. Dragged nodes are none of them. Collective.
  std::vector<double> frictionless_parts(const ContactSurface &surface,
                                         const State &state);

  /// By how much friction fell as nodes slipped since the origin, as a part of what it
  /// could bear there, of each contact boundary. Collective.
  ///
  /// @param state at the end of a step, with the path up to there in its history.
  std::vector<double> falls_of_friction(const ContactSurface &surface,
                                        const State &state);
} // namespace stiction
