#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace stiction
{
  class Body;

  /// The smooth surface that the faces of cells stand for, which are flat or, of
  /// triquadratic ones, parabolic: through their nodes, with the mean normals of the
  /// faces around these.
  ///
  /// Between nodes x_i with normals n_i and shape functions w_i it is at p + s n, with p
  /// = Σ w_i x_i, L n = Σ w_i n_i, |n| = 1 and s = −Σ w_i (p − x_i)·n_i/(1 + L): about
  /// halfway between the flat face and the mean of the tangent planes. With right normals
  /// that is exact on spheres and circular cylinders of radius R, on which p = R L n and
  /// s = R(1 − L) but for the length along the cylinder; it is so to O(h³) elsewhere, and
  /// to O(h²) at the rim of a boundary, where faces are on one side of a vertex only.
  /// (After T. Boubekeur, M. Alexa, Phong tessellation, 2008.)
  ///
  /// Where the faces at a vertex are more than 20° off their mean, so meet at more
  /// than 40°, there is an edge, and each keeps its own normal: nine faces or more make
  /// a circle, and a chamfer of 45° remains one. Flat faces remain what they are.
  class SmoothBoundary
  {
  public:
    /// Finds the normals. Collective. @param body must outlive this.
    SmoothBoundary(const Body &body, const std::set<dealii::types::boundary_id> &ids);

    /// A point of the surface.
    struct Place
    {
      dealii::Point<3> position;   ///< m
      dealii::Tensor<1, 3> normal; ///< outward, of length one
    };

    /// The nodes of a face; vertices that hang are put on the surface, too.
    using Face = std::vector<Place>;

    /// @param cell owned by this rank. @param f its face, on a boundary of ids.
    Face face(const dealii::DoFHandler<3>::active_cell_iterator &cell,
              unsigned int f) const;

    /// Where it is at the quadrature points of a face of a contact boundary.
    std::vector<Place> at_points(
      const dealii::FEFaceValues<3> &values,
      const dealii::DoFHandler<3>::active_cell_iterator &cell) const;

    /// Where the surface is. @param weights the shape functions of the nodes.
    static Place at(const Face &face, const std::vector<double> &weights);

  private:
    // Its vertices where they are on the curved body.
    std::array<dealii::Point<3>, 8> vertices(
      const dealii::DoFHandler<3>::active_cell_iterator &cell) const;

    // Of the nodes of a face.
    std::vector<dealii::types::global_dof_index> first_dofs(
      const dealii::DoFHandler<3>::active_cell_iterator &cell, unsigned int f) const;

    // With the normals of this face alone.
    Face as_it_is(const dealii::DoFHandler<3>::active_cell_iterator &cell,
                  unsigned int f) const;

    void add_normals(const dealii::DoFHandler<3>::active_cell_iterator &cell,
                     unsigned int f);

    // Of length one. @param own that of the face that asks
    static dealii::Tensor<1, 3> normal(dealii::types::global_dof_index first_dof,
                                       const LA::Vector &normals,
                                       const dealii::Tensor<1, 3> &own);

    const Body &body_;
    std::unique_ptr<dealii::FEFaceValues<3>> at_nodes_;        // none of trilinear cells
    std::map<dealii::types::boundary_id, LA::Vector> normals_; // of any length
  };
} // namespace stiction
