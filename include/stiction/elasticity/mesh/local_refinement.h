#ifndef stiction_elasticity_mesh_local_refinement_h
#define stiction_elasticity_mesh_local_refinement_h

namespace stiction
{
  class Body;
  class Parameters;

  /// Refines the cells at the contact boundary as often and where 'Geometry'
  /// says. Collective.
  ///
  /// Throws InputError if the contact boundary does not exist or the formula
  /// cannot be read.
  void refine_contact_boundary(Body &body, const Parameters &parameters);
} // namespace stiction

#endif
