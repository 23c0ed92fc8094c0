#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <map>
#include <memory>
#include <vector>

namespace stiction
{
  class LinearElasticity;

  /// The forces of the supports on the body, R = Ku − f − c at the prescribed
  /// unknowns and 0 at the others, f being the loads and c the contact forces.
  ///
  /// Only the components that are prescribed count, whatever value they have.
  /// Each goes to one support: to the prescribed point if there is one, else to
  /// the boundary with the lowest id among those that prescribe it. The sum of
  /// all supports, loads and contact forces is therefore zero, as far as the
  /// displacement is in equilibrium.
  class SupportReactions
  {
  public:
    /// Collective.
    ///
    /// @param u the displacement, hanging nodes following the others.
    /// @param contact_force c, the nodal forces on the body besides the loads.
    SupportReactions(const LinearElasticity &elasticity, const LA::Vector &u,
                     const LA::Vector &contact_force);
    ~SupportReactions();

    /// R. Unit: of force.
    const LA::Vector &nodal() const { return *nodal_; }

    /// A resultant and its moment about the origin.
    struct OnBoundary
    {
      dealii::Tensor<1, 3> force, moment;
    };

    /// Of all boundaries with prescribed components.
    const std::map<dealii::types::boundary_id, OnBoundary> &boundaries() const
    {
      return boundaries_;
    }

    /// A node and the force on it.
    struct AtPoint
    {
      dealii::Point<3> at;
      dealii::Tensor<1, 3> force;
    };

    /// Of the prescribed points, in the order of the parameter file.
    const std::vector<AtPoint> &points() const { return points_; }

  private:
    std::unique_ptr<LA::Vector> nodal_;
    std::map<dealii::types::boundary_id, OnBoundary> boundaries_;
    std::vector<AtPoint> points_;
  };
} // namespace stiction
