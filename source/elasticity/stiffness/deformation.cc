#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/deformation.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stiction
{
  using namespace dealii;

  Deformation largest_deformation(const Body &body, const LA::Vector &u)
  {
    const LA::Vector ghosted = body.with_ghosts(u);
    const Point<3> middle(.5, .5, .5);
    Deformation largest;
    for (const auto &cell : body.locally_owned_cells())
      {
        Tensor<2, 3> places, displacements; // their gradients on the unit cell
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto gradient =
              GeometryInfo<3>::d_linear_shape_function_gradient(middle, v);
            for (unsigned int c = 0; c < 3; ++c)
              {
                places[c] += cell->vertex(v)[c] * gradient;
                displacements[c] += ghosted(cell->vertex_dof_index(v, c)) * gradient;
              }
          }
        const Tensor<2, 3> gradient        = displacements * invert(places);
        const SymmetricTensor<2, 3> strain = symmetrize(gradient);
        const Tensor<2, 3> turned          = gradient - Tensor<2, 3>(strain);
        largest.rotation = std::max(largest.rotation, turned.norm() / std::sqrt(2.));
        if (strain.norm() <= largest.strain) // so are its eigenvalues
          continue;
        for (const double principal : eigenvalues(strain))
          largest.strain = std::max(largest.strain, std::abs(principal));
      }
    return {Utilities::MPI::max(largest.strain, body.communicator()),
            Utilities::MPI::max(largest.rotation, body.communicator())};
  }
} // namespace stiction
