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
#include <set>
#include <vector>

namespace stiction
{
  class Body;

  /// The smooth surface that the flat faces of trilinear cells stand for: through
  /// their vertices, with the mean normals of the faces around these.
  ///
  /// Between vertices x_i with normals n_i and weights w_i it is at p − ½ Σ w_i
  /// ((p − x_i)·n_i) n_i, p = Σ w_i x_i, halfway between the flat face and the mean of
  /// the tangent planes. That is exact where the surface is quadratic and the normals
  /// are right, and off by O(h³) elsewhere, by O(h²) at the rim of a boundary, where
  /// faces are on one side of a vertex only. (As T. Boubekeur, M. Alexa, Phong
  /// tessellation, 2008, whose share of the planes is ¾.)
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

    /// The vertices of a face; those that hang are put on the surface, too.
    using Face = std::array<Place, 4>;

    /// @param cell owned by this rank. @param f its face, on a boundary of ids.
    Face face(const dealii::DoFHandler<3>::active_cell_iterator &cell,
              unsigned int f) const;

    /// Where it is at the quadrature points of a face of a contact boundary; with
    /// elements of higher degree, whose faces are curved, those points themselves.
    std::vector<Place> at_points(
      const dealii::FEFaceValues<3> &values,
      const dealii::DoFHandler<3>::active_cell_iterator &cell) const;

    /// Where the surface is. @param weights the bilinear shape functions.
    static Place at(const Face &face, const std::array<double, 4> &weights);

  private:
    // Its vertices where they are on the curved body.
    std::array<dealii::Point<3>, 8> vertices(
      const dealii::DoFHandler<3>::active_cell_iterator &cell) const;

    void add_normals(const dealii::DoFHandler<3>::active_cell_iterator &cell,
                     unsigned int f);

    // Of length one. @param flat that of the face that asks
    static dealii::Tensor<1, 3> normal(dealii::types::global_dof_index first_dof,
                                       const LA::Vector &normals,
                                       const dealii::Tensor<1, 3> &flat);

    const Body &body_;
    std::map<dealii::types::boundary_id, LA::Vector> normals_; // of any length
  };
} // namespace stiction
