#pragma once

#include <stiction/contact/pairs/surface_face.h>

#include <deal.II/base/types.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace stiction
{
  class LinearElasticity;

  /// How the nodes of one surface, the slave, see the displacement of another one, the
  /// master, that lies opposite to it: the dual mortar method of Wohlmuth (2000),
  ///
  ///     D_ii = ∫ φ_i,   M_ij = ∫ ψ_i φ_j,   W = D⁻¹ M,
  ///
  /// with ψ_i dual to the shape functions φ_i on the part of each slave face that is
  /// covered, of several bodies opposite on the part of each: ∫ ψ_i ≥ 0 there, so that no
  /// force that presses on all of them pulls one. All integrals of a face are sums over
  /// the same points, so that W keeps constants, and linear functions where the surfaces
  /// are the same plane, whatever the quadrature: forces λ on the slave and −Wᵀλ on the
  /// master add to none. For their moments see with_rigid_turns().
  ///
  /// Where nodes hang on others by u = C û, D is CᵀDC and M is CᵀMC.
  struct Mortar
  {
    /// The slave nodes that have something opposite, by their first unknowns.
    std::vector<dealii::types::global_dof_index> slaves;
    Eigen::VectorXd areas; ///< D of each, of the covered part, m²
    /// The mean of the distance to the master along the normals of the slave faces,
    /// weighted by ψ, but not beyond what there is around the node, m.
    Eigen::VectorXd gaps;

    /// Of each node at the rim of the slave faces the mean of the outward normals of the
    /// master opposite, unit; of the others zero; by rows.
    Eigen::MatrixX3d normals;

    /// Of each the largest of the cells of the master opposite, Pa.
    Eigen::VectorXd youngs_moduli;

    /// Of each the largest part of a face around it that has something opposite, above 1
    /// where there is more than one sheet of it.
    Eigen::VectorXd covers;

    /// The master nodes.
    std::vector<dealii::types::global_dof_index> masters;
    Eigen::SparseMatrix<double, Eigen::RowMajor> weights;  ///< W, slaves × masters
    Eigen::SparseMatrix<double, Eigen::RowMajor> overlaps; ///< ∫ |φ_i φ_j|, as many

    /// The smallest side of the boxes around the bodies, m. What overlaps by more is not
    /// opposite: the far sides of two balls look at each other through both.
    double thickness        = 0.;
    double deepest_left_out = 0.; ///< the deepest such overlap, m

    /// By how much facets may keep surfaces apart that fit: the depth_of_facets() of
    /// both, m.
    double facets = 0.;

    /// Finds them. Collective.
    Mortar(const LinearElasticity &elasticity,
           const std::vector<SurfaceFace> &slave_faces,
           const std::vector<SurfaceFace> &master_faces);

    /// The row of a slave node, -1 if it has nothing opposite.
    Eigen::Index row_of(dealii::types::global_dof_index slave) const;

    /// Whether a slave is a master as well: the tip of a crack, which the mesh holds
    /// together.
    bool is_of_both(dealii::types::global_dof_index slave) const;

    /// The largest of the gaps and overlaps, m.
    double largest_gap() const
    {
      return slaves.empty() ? 0. : gaps.lpNorm<Eigen::Infinity>();
    }
  };
} // namespace stiction
