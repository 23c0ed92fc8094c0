// The contact nodes: frames are orthonormal, areas add up to the contact
// boundary less what belongs to its clamped edge, B Bᵀ is the identity, the
// tangents follow the convention for any normal.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>

using namespace stiction;

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Parameters parameters;
  parameters.read(shipped("brick.prm"),
                  {"Geometry/Table 1 level=1", "Friction/Coefficient=0.1*(1+x+y)",
                   "Boundary conditions/Initial gap=1e-3*(x+2*y)"});
  const Body body(parameters.geometry, MPI_COMM_WORLD);
  const LinearElasticity elasticity(body, parameters.of_body());
  const ContactSurface surface(elasticity, parameters.of_contact());
  const Eigen::Index m = surface.n_nodes();

  out() << "nodes of the body " << body.n_nodes() << ", contact nodes " << m << std::endl;
  // 4 × 3 m² in 8 × 6 cells: half a row of cells belongs to the clamped edge
  out() << "area of the boundary " << surface.boundary_area() << ", of the contact nodes "
        << surface.areas().sum() << std::endl;

  double frames = 0., data = 0.;
  bool sorted = true;
  for (Eigen::Index i = 0; i < m; ++i)
    {
      const ContactNode &node = surface.nodes()[i];
      frames += (node.normal - dealii::Tensor<1, 3>({0., 0., -1.})).norm() +
                (node.tangent1 - dealii::Tensor<1, 3>({1., 0., 0.})).norm() +
                (node.tangent2 - dealii::Tensor<1, 3>({0., 1., 0.})).norm();
      data +=
        std::abs(node.coefficient - 0.1 * (1. + node.position[0] + node.position[1])) +
        std::abs(node.gap - 1e-3 * (node.position[0] + 2. * node.position[1]));
      sorted = sorted && node.position[1] > 0. && node.position[2] == 0. &&
               (i == 0 || node.position[0] > surface.nodes()[i - 1].position[0] - 1e-12);
    }
  out() << "frames are those of the foundation z = 0: " << yes(frames < 1e-13)
        << ", data are those of the place: " << yes(data < 1e-13)
        << ", ordered by place: " << yes(sorted) << std::endl;

  // B Bᵀ = 1, on vectors that are no constants
  const Eigen::VectorXd lambda = Eigen::VectorXd::LinSpaced(3 * m, -1., 3.);
  LA::Vector force             = elasticity.zero_vector();
  surface.B().add_transpose(2., lambda, force);
  const Eigen::VectorXd back = surface.B().apply(force);
  out() << "B Bt is the identity: "
        << yes((back - 2. * lambda).norm() < 1e-13 * lambda.norm()) << std::endl;

  for (const dealii::Tensor<1, 3> normal :
       {dealii::Tensor<1, 3>({0.6, 0., -0.8}), dealii::Tensor<1, 3>({0.96, -0.28, 0.}),
        dealii::Tensor<1, 3>({1., 0., 0.})})
    {
      ContactNode node;
      node.normal = normal;
      set_tangents(node);
      const double error =
        std::abs(node.tangent1 * normal) + std::abs(node.tangent2 * normal) +
        std::abs(node.tangent1 * node.tangent2) + std::abs(node.tangent1.norm() - 1.) +
        std::abs(node.tangent2.norm() - 1.);
      out() << "normal " << normal << ": orthonormal " << yes(error < 1e-14)
            << ", t1 = " << node.tangent1 << ", t2 = " << node.tangent2 << std::endl;
    }
}
