#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <array>
#include <string>
#include <vector>

namespace stiction
{
  class LinearElasticity;

  /// A face of a cell on a boundary, as all ranks know it: a Lagrange quadrilateral of
  /// the degree of the elements.
  struct SurfaceFace
  {
    unsigned int degree;
    /// The first unknowns of the (degree + 1)² nodes, along the first edge first.
    std::array<dealii::types::global_dof_index, 9> dofs;
    std::array<std::array<double, 3>, 9> nodes; ///< where they are, m
    std::array<double, 3> inside;               ///< the centre of the cell, m
    double youngs_modulus;                      ///< of the cell, Pa
    unsigned int piece;                         ///< of the mesh, see Body::pieces()
    double coarse_diameter;                     ///< of the face before refinement, m
    double surface_size; ///< the diagonal of the box around all of the surface, m
    double thickness;    ///< the smallest side of the boxes around its bodies, m
    bool is_round;       ///< that of a circle of some ten or fewer

    unsigned int n_nodes() const { return (degree + 1) * (degree + 1); }

    dealii::Point<3> node(const unsigned int i) const
    {
      return {nodes[i][0], nodes[i][1], nodes[i][2]};
    }

    /// The four corners, going around: their first unknowns, and where they are.
    std::array<dealii::types::global_dof_index, 4> corner_dofs() const;
    std::array<dealii::Point<3>, 4> corners() const;

    /// The mean of the corners.
    dealii::Point<3> centre() const;

    /// Unit, outward, by the diagonals.
    dealii::Tensor<1, 3> normal() const;

    /// That of the flat quadrilateral between the corners, m².
    double area() const;

    /// The longer diagonal, m.
    double diameter() const;
  };

  /// The shape functions of a face at a point of the unit square, of which only the
  /// first (degree + 1)² count, and their derivatives.
  struct FaceShape
  {
    FaceShape(unsigned int degree, const std::array<double, 2> &at);

    std::array<double, 9> value;
    std::array<std::array<double, 2>, 9> gradient;
  };

  /// Sines of half of the angle between faces: less is flat, more an edge of the body, of
  /// 40 degrees.
  constexpr double flat_kink = 1e-3, sharp_kink = 0.34;

  /// Of each face, by the sines of half of the angles to the next ones: the least and the
  /// most of its corners.
  std::vector<std::array<double, 2>> kinks(const std::vector<SurfaceFace> &faces);

  /// Below this cosine between an outward normal and the direction towards another
  /// surface it faces away from that.
  constexpr double facing_cosine = 0.1;

  /// How far the faces of a round surface are below it at most, m: of one with the angle
  /// θ to the next face and the size h, before refinement if that left it flat, it is
  /// θh/8.
  double depth_of_facets(const std::vector<SurfaceFace> &faces);

  /// Why nothing of one surface is opposite to the other, from where they are nearest, a
  /// part of a sentence that begins with "they".
  std::string why_not_opposite(const std::vector<SurfaceFace> &first,
                               const std::vector<SurfaceFace> &second);

  /// The mean of their diameters, m.
  double mean_diameter(const std::vector<SurfaceFace> &faces);

  /// Those of some boundaries, the same list on all ranks. Collective.
  std::vector<SurfaceFace> surface_faces(
    const LinearElasticity &elasticity,
    const std::vector<dealii::types::boundary_id> &ids);
} // namespace stiction
