#ifndef stiction_elasticity_prescribed_displacement_h
#define stiction_elasticity_prescribed_displacement_h

#include <stiction/elasticity/boundary_functions.h>

#include <deal.II/lac/affine_constraints.h>

#include <string>

namespace stiction
{
  class Body;
  class Parameters;

  /// What the entry Prescribed displacement says: where the body is held or
  /// moved, component by component.
  class PrescribedDisplacement
  {
  public:
    /// Throws InputError if the entry cannot be read.
    PrescribedDisplacement(const Body &body, const Parameters &parameters);

    /// Whether all components are prescribed there, so that a load would go
    /// into the support at once.
    bool
    holds_completely(dealii::types::boundary_id boundary) const;

    /// Adds the prescribed values to constraints that are not closed. Unknowns
    /// that are constrained already are left alone. Collective.
    ///
    /// Throws InputError if a formula has no finite value, or if two boundaries
    /// prescribe different values at a node they share.
    void
    add_to(dealii::AffineConstraints<double> &constraints) const;

    /// Throws InputError, naming the free rigid-body motions, if the
    /// constraints do not hold the body. Collective.
    void
    require_support(const dealii::AffineConstraints<double> &constraints) const;

  private:
    const Body &body_;
    const std::string location_;
    BoundaryFunctions functions_;
  };
} // namespace stiction

#endif
