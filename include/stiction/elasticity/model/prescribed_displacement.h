#pragma once

#include <stiction/base/text/boundary_functions.h>

#include <deal.II/base/point.h>
#include <deal.II/lac/affine_constraints.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  class Body;
  struct BodyParameters;

  /// What the entries Prescribed displacement and Prescribed points say: where
  /// the body is held or moved, component by component.
  class PrescribedDisplacement
  {
  public:
    /// @param time the value of t.
    ///
    /// Throws InputError if the entries cannot be read.
    PrescribedDisplacement(const Body &body, const BodyParameters &parameters,
                           double time);

    /// What is prescribed where, for people: "front", "x y z" for what is held
    /// and "top", "x = 1e-3, y = 0" for what is moved, of boundaries by name
    /// and then of points.
    std::vector<std::pair<std::string, std::string>> description() const;

    /// The components prescribed on a boundary: "xyz", "x", "".
    std::string components(dealii::types::boundary_id boundary) const;

    /// Whether all components are prescribed there, so that a load would go
    /// into the support at once.
    bool holds_completely(dealii::types::boundary_id boundary) const;

    /// Adds the prescribed values to constraints that are not closed. Unknowns
    /// that are constrained already are left alone. Collective.
    ///
    /// Throws InputError if a formula has no finite value, if two boundaries
    /// prescribe different values at a node they share, or if there is no node
    /// at a prescribed point, or one that is prescribed otherwise or hangs.
    void add_to(dealii::AffineConstraints<double> &constraints) const;

    /// The unknowns of own and neighbouring cells that boundaries prescribe,
    /// with the lowest id among those that do. Hanging nodes may be among them.
    std::map<dealii::types::global_dof_index, dealii::types::boundary_id>
    supporting_boundaries() const;

    /// All boundaries with prescribed components.
    std::set<dealii::types::boundary_id> boundaries() const;

    /// The node of a prescribed point, whoever owns it.
    struct SupportedNode
    {
      dealii::types::global_dof_index first_dof;
      dealii::Point<3> position;
      dealii::ComponentMask components; ///< those that are prescribed
    };

    /// Of all prescribed points, in the order of the parameter file.
    /// Collective. Throws InputError if there is no node at one of them.
    std::vector<SupportedNode> supported_nodes() const;

  private:
    struct PrescribedPoint
    {
      dealii::Point<3> position;
      BoundaryFunction displacement;
    };

    void add_points_to(dealii::AffineConstraints<double> &constraints) const;

    SupportedNode node_of(const PrescribedPoint &point) const;

    const Body &body_;
    const std::string location_;
    BoundaryFunctions functions_;
    const std::string points_location_;
    std::vector<PrescribedPoint> points_;
  };
} // namespace stiction
