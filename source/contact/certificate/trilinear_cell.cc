#include "trilinear_cell.h"

#include <deal.II/base/geometry_info.h>

#include <cmath>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // ∇φ_k of the eight shape functions at the points of the six faces
    using ShapeGradients = std::array<std::array<std::array<Tensor<1, 3>, 8>, 4>, 6>;

    ShapeGradients gradients_on_faces()
    {
      ShapeGradients gradients;
      for (unsigned int f = 0; f < 6; ++f)
        for (unsigned int a = 0; a < 4; ++a)
          {
            Point<3> place = GeometryInfo<3>::unit_cell_vertex(
              GeometryInfo<3>::face_to_cell_vertices(f, a));
            for (unsigned int d = 0; d < 3; ++d)
              if (d != f / 2)
                place[d] = 0.5 + (place[d] - 0.5) / std::sqrt(3.);
            for (unsigned int k = 0; k < 8; ++k)
              gradients[f][a][k] =
                GeometryInfo<3>::d_linear_shape_function_gradient(place, k);
          }
      return gradients;
    }
  } // namespace

  TrilinearCell::TrilinearCell(const DoFHandler<3>::active_cell_iterator &cell,
                               const LA::Vector &u)
  {
    for (unsigned int k = 0; k < 8; ++k)
      {
        vertices_[k]                            = cell->vertex(k);
        const types::global_dof_index first_dof = cell->vertex_dof_index(k, 0);
        for (unsigned int c = 0; c < 3; ++c)
          u_[k][c] = u(first_dof + c);
      }
  }

  TrilinearCell::Place TrilinearCell::at(const unsigned int face,
                                         const unsigned int vertex_of_face) const
  {
    static const ShapeGradients on_faces = gradients_on_faces();
    const auto &gradients                = on_faces[face][vertex_of_face];
    Tensor<2, 3> jacobian, derivative; // by the coordinates of the unit cell
    for (unsigned int k = 0; k < 8; ++k)
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          {
            jacobian[c][d] += vertices_[k][c] * gradients[k][d];
            derivative[c][d] += u_[k][c] * gradients[k][d];
          }
    const Tensor<2, 3> inverse = invert(jacobian);
    const Tensor<1, 3> &row    = inverse[face / 2];
    Place place;
    place.strain = symmetrize(derivative * inverse);
    place.height = 1. / row.norm();
    place.normal = (face % 2 == 0 ? -1. : 1.) * place.height * row;
    place.JxW    = std::abs(determinant(jacobian)) / place.height / 4.;
    return place;
  }
} // namespace stiction
