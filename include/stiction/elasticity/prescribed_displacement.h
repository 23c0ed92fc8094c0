#ifndef stiction_elasticity_prescribed_displacement_h
#define stiction_elasticity_prescribed_displacement_h

#include <stiction/elasticity/boundary_functions.h>

#include <deal.II/base/point.h>
#include <deal.II/lac/affine_constraints.h>

#include <string>
#include <vector>

namespace stiction
{
  class Body;
  class Parameters;

  /// What the entries Prescribed displacement and Prescribed points say: where
  /// the body is held or moved, component by component.
  class PrescribedDisplacement
  {
  public:
    /// Throws InputError if the entries cannot be read.
    PrescribedDisplacement(const Body &body, const Parameters &parameters);

    /// The components prescribed on a boundary: "xyz", "x", "".
    std::string
    components(dealii::types::boundary_id boundary) const;

    /// Whether all components are prescribed there, so that a load would go
    /// into the support at once.
    bool
    holds_completely(dealii::types::boundary_id boundary) const;

    /// Adds the prescribed values to constraints that are not closed. Unknowns
    /// that are constrained already are left alone. Collective.
    ///
    /// Throws InputError if a formula has no finite value, if two boundaries
    /// prescribe different values at a node they share, or if there is no node
    /// at a prescribed point, or one that is prescribed otherwise or hangs.
    void
    add_to(dealii::AffineConstraints<double> &constraints) const;

    /// Throws InputError, naming the free rigid-body motions, if the
    /// constraints do not hold the body. Collective.
    void
    require_support(const dealii::AffineConstraints<double> &constraints) const;

  private:
    void
    add_points_to(dealii::AffineConstraints<double> &constraints) const;

    struct PrescribedPoint
    {
      dealii::Point<3> position;
      BoundaryFunction displacement;
    };

    const Body &body_;
    const std::string location_;
    BoundaryFunctions functions_;
    const std::string points_location_;
    std::vector<PrescribedPoint> points_;
  };
} // namespace stiction

#endif
