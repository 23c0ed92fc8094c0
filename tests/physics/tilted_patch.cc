// The patch test on a contact face at an arbitrary angle: the distorted block
// of parameters/meshes, turned about two axes, on a foundation that is turned
// with it, on a plane given as an obstacle, and on the same plane as a formula.
// The exact solution of patch_test.h is turned, too.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>
#include <fstream>

using namespace stiction;
using dealii::Tensor;

namespace
{
  constexpr double E = 2e11, nu = 0.3, epsilon = 1e-4, height = 1., mu = 0.25;

  Tensor<2, 3> rotation()
  {
    const double a = 0.7, b = -1.9;
    Tensor<2, 3> about_x, about_y;
    about_x[0][0] = about_y[1][1] = 1.;
    about_x[1][1] = about_x[2][2] = std::cos(a);
    about_x[1][2]                 = -std::sin(a);
    about_x[2][1]                 = std::sin(a);
    about_y[0][0] = about_y[2][2] = std::cos(b);
    about_y[0][2]                 = std::sin(b);
    about_y[2][0]                 = -std::sin(b);
    return about_y * about_x;
  }

  const Tensor<2, 3> R = rotation();

  std::string turned(const double x, const double y, const double z)
  {
    const Tensor<1, 3> v = R * Tensor<1, 3>({x, y, z});
    return exact(v[0]) + ";" + exact(v[1]) + ";" + exact(v[2]);
  }

  // The shipped mesh with its nodes turned.
  void write_turned_mesh()
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ifstream in(shipped("meshes/distorted_block_22.msh"));
        std::ofstream file("turned.msh");
        file.precision(17);
        std::string line;
        unsigned int n_nodes = 0;
        while (std::getline(in, line))
          {
            file << line << '\n';
            if (line != "$Nodes")
              continue;
            in >> n_nodes;
            file << n_nodes << '\n';
            for (unsigned int i = 0; i < n_nodes; ++i)
              {
                unsigned int number;
                Tensor<1, 3> x;
                in >> number >> x[0] >> x[1] >> x[2];
                file << number << ' ' << R * x << '\n';
              }
            std::getline(in, line); // the rest of the last line
          }
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }

  void patch(const std::string &name, const std::vector<std::string> &obstacle,
             const std::string &method, const bool sticks)
  {
    const double lame  = E * nu / ((1. + nu) * (1. - 2. * nu));
    const double G     = E / (2. * (1. + nu));
    const double p     = (lame + 2. * G) * epsilon;
    const double shift = sticks ? 3e-5 : 2e-4;
    const double gamma = sticks ? shift / height : mu * p / G;
    const double s     = shift - gamma * height;
    const double cx = std::cos(1.1), cy = std::sin(1.1);
    const double sxx = -lame * epsilon;
    const double sxz = G * gamma * cx, syz = G * gamma * cy;

    std::vector<std::string> settings = {
      "Geometry/Table 1 level=0",
      "Geometry/Type=file",
      "Geometry/Mesh file=turned.msh",
      "Geometry/Global refinement=1",
      "Material/Young's modulus=" + exact(E),
      "Material/Poisson ratio=" + exact(nu),
      "Boundary conditions/Contact boundary=bottom",
      "Boundary conditions/Prescribed displacement=top : " +
        turned(shift * cx, shift * cy, -epsilon * height),
      "Boundary conditions/Traction=left : " + turned(-sxx, 0, -sxz) +
        " | right : " + turned(sxx, 0, sxz) + " | front : " + turned(0, -sxx, -syz) +
        " | back : " + turned(0, sxx, syz),
      "Friction/Coefficient=" + exact(mu),
      "Contact solver/Tolerance=1e-11",
      "Contact solver/Method=" + method};
    settings.insert(settings.end(), obstacle.begin(), obstacle.end());
    const Run run(shipped("brick.prm"), settings);

    double error_u = 0., error_force = 0.;
    const auto &u = run.problem->state().u;
    for (const auto &node : run.problem->elasticity().body().locally_owned_nodes())
      {
        const double z = (transpose(R) * Tensor<1, 3>(node.position))[2];
        const Tensor<1, 3> exact_u =
          R * Tensor<1, 3>({cx * (gamma * z + s), cy * (gamma * z + s), -epsilon * z});
        for (unsigned int c = 0; c < 3; ++c)
          error_u = std::max(error_u, std::abs(u(node.dofs[c]) - exact_u[c]) / shift);
      }
    error_u = dealii::Utilities::MPI::max(error_u, MPI_COMM_WORLD);

    const ContactSurface &surface = run.problem->contact_surface();
    const Eigen::VectorXd force =
      surface.B().force_to_cartesian(run.problem->state().lambda);
    const Eigen::Index m        = surface.n_nodes();
    const Tensor<1, 3> per_area = R * Tensor<1, 3>({sxz, syz, -p});
    for (Eigen::Index i = 0; i < m; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        error_force = std::max(
          error_force, std::abs(force(i + c * m) / surface.areas()(i) - per_area[c]) / p);
    out() << name << ", " << method << ", " << (sticks ? "stick" : "slip")
          << ": certified " << yes(run.converged) << ", displacement exact to 1e-8 "
          << yes(error_u < 1e-8) << ", contact forces exact to 1e-8 "
          << yes(error_force < 1e-8) << '\n';
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  write_turned_mesh();
  const Tensor<1, 3> n = R * Tensor<1, 3>({0, 0, 1});
  const std::string plane =
    exact(n[0]) + "*x+" + exact(n[1]) + "*y+" + exact(n[2]) + "*z";
  for (const bool sticks : {true, false})
    for (const std::string method : {"gauss seidel", "newton multigrid"})
      {
        patch("foundation", {}, method, sticks);
        patch("plane",
              {"Boundary conditions/Obstacle=plane : 0; 0; 0; " + exact(n[0]) + "; " +
               exact(n[1]) + "; " + exact(n[2])},
              method, sticks);
        patch("formula",
              {"Boundary conditions/Obstacle=formula : (" + plane + ")*(2+sin(x))"},
              method, sticks);
      }
}
