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
    double turn     = 0.; ///< by how much normals are, radians
    double slip     = 0.; ///< how far nodes are from where they were on it, m
    double spacing  = 0.; ///< the distance of nodes, m
    /// By how much normals have turned with the body since it was undeformed, radians:
    /// what the rotation that fits the displacement of these nodes best explains of it.
    /// It leaves nothing out, and 'Sliding = far', which lets normals turn beside a
    /// stiffness that does not, does.
    double with_body   = 0.;
    double coefficient = 0.; ///< the largest of Coulomb's law there
  };

  /// Zeros where a boundary has no obstacle with a shape. Collective.
  ObstacleDeparture obstacle_departure(const ContactSurface &surface,
                                       const ContactBoundary &boundary,
                                       const State &state);
} // namespace stiction
