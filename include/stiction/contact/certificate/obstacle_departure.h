#pragma once

namespace stiction
{
  class ContactBoundary;
  class ContactSurface;
  struct State;

  /// What the linearisation of an obstacle about where nodes were leaves out: means over
  /// the pressed nodes of a boundary, weighted with their forces.
  struct ObstacleDeparture
  {
    double distance = 0.; ///< by how much gaps are others where nodes came to, m
    double turn     = 0.; ///< by how much normals are, but for turns of the body, radians
    double slip     = 0.; ///< how far nodes are from where they were on it, m
    double spacing  = 0.; ///< the distance of nodes, m
    /// By how much the body turns there: the rotation that fits the displacement of these
    /// nodes best, radians. Normals that turn with the body leave nothing out, and
    /// 'Sliding = far', which lets them turn beside a stiffness that does not, does.
    double body_turn   = 0.;
    double coefficient = 0.; ///< the largest of Coulomb's law there
  };

  /// Zeros where a boundary has no obstacle with a shape. Collective.
  ObstacleDeparture obstacle_departure(const ContactSurface &surface,
                                       const ContactBoundary &boundary,
                                       const State &state);
} // namespace stiction
