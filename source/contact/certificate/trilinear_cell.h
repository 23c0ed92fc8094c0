#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>

namespace stiction
{
  /// The strain of a trilinear displacement on the faces of a trilinear
  /// hexahedron: what deal.II's FEFaceValues says, in a fraction of its time.
  class TrilinearCell
  {
  public:
    /// @param u must know the displacement of the cell's vertices.
    TrilinearCell(const dealii::DoFHandler<3>::active_cell_iterator &cell,
                  const LA::Vector &u);

    /// Of the 2×2 Gauss points of a face the one nearest to a vertex of it.
    struct Place
    {
      dealii::SymmetricTensor<2, 3> strain;
      dealii::Tensor<1, 3> normal; ///< outward, of length one
      double height;               ///< of the cell above the face, m
      double JxW;                  ///< m²
    };
    Place at(unsigned int face, unsigned int vertex_of_face) const;

  private:
    std::array<dealii::Point<3>, 8> vertices_;
    std::array<dealii::Tensor<1, 3>, 8> u_;
  };
} // namespace stiction
