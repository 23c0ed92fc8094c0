#pragma once

#include <deal.II/base/tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;

  /// The contact tractions on the body −(Bᵀλ)_i/A_i, interpolated between the
  /// nodes; of nodes beyond the edge of what lies opposite, on either side of a pair,
  /// spread over half of what is around them. Where a node of the contact boundary is
  /// held and its contact force is not known, it is the mean of the face's other nodes.
  class ContactTraction
  {
  public:
    /// Collective.
    ContactTraction(const LinearElasticity &elasticity, const ContactSurface &surface,
                    const Eigen::VectorXd &lambda);

    /// At the quadrature points of a face of a contact boundary, Pa; nothing if
    /// it is known at none of its nodes.
    std::vector<dealii::Tensor<1, 3>> at_points(
      const dealii::FEFaceValues<3> &values,
      const dealii::DoFHandler<3>::cell_iterator &cell);

  private:
    // Zero at a free node that faces away from the obstacle; nothing where a
    // support may carry the load, or another contact boundary.
    std::optional<dealii::Tensor<1, 3>> at_node(dealii::types::global_dof_index first_dof,
                                                dealii::types::boundary_id id,
                                                unsigned int part) const;

    const LinearElasticity &elasticity_;
    const ContactSurface &surface_;
    const Eigen::VectorXd at_nodes_; // tractions on the obstacle, by blocks (x; y; z)
    Eigen::VectorXd opposite_;       // at the nodes opposite, by blocks
    const dealii::FiniteElement<3> &fe_;
    std::vector<dealii::types::global_dof_index> dofs_;
  };
} // namespace stiction
