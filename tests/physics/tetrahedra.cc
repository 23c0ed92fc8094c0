// Bodies of tetrahedra and prisms, which are cut into hexahedra. The patch test on a
// flat and on a tilted contact face, with straight and with curved cells: pressed onto
// the foundation and sheared until the face sticks or slips, the exact solution is
// linear. Then a sphere in a block, with the force that hexahedra find.

#include "cut_block_file.h"
#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>

using namespace stiction;
using dealii::Point;
using dealii::Tensor;

namespace
{
  Tensor<2, 3> rotation(const double a, const double b)
  {
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

  // In the unit cube, whose faces remain where they are.
  Point<3> bent(const Point<3> &q)
  {
    Point<3> p = q;
    for (unsigned int d = 0; d < 3; ++d)
      p[d] += (.3 + .1 * d) * q[d] * (1. - q[d]) *
              std::sin(2. + 3. * q[(d + 1) % 3] + 5. * q[(d + 2) % 3]);
    return p;
  }

  void patch(const std::string &title, const CutBlockFile::Kind &kind,
             const unsigned int order, const std::string &method, const Tensor<2, 3> &R,
             const bool sticks)
  {
    constexpr double E = 2e11, nu = 0.3, epsilon = 1e-4, mu = 0.25;
    const double lame  = E * nu / ((1. + nu) * (1. - 2. * nu));
    const double G     = E / (2. * (1. + nu));
    const double p     = (lame + 2. * G) * epsilon;
    const double shift = sticks ? 3e-5 : 2e-4;
    const double gamma = sticks ? shift : mu * p / G;
    const double s     = shift - gamma;
    const double cx = std::cos(1.1), cy = std::sin(1.1);
    const double sxx = -lame * epsilon;
    const double sxz = G * gamma * cx, syz = G * gamma * cy;
    const auto turned = [&](const double x, const double y, const double z) {
      const Tensor<1, 3> v = R * Tensor<1, 3>({x, y, z});
      return three(v[0], v[1], v[2]);
    };

    CutBlockFile(
      {{2, 2, 2}}, kind,
      [&](const Point<3> &q) { return Point<3>(R * (order == 2 ? bent(q) : q)); }, order)
      .write("patch.msh");
    const Run run(
      shipped("brick.prm"),
      {"Geometry/Table 1 level=0", "Geometry/Type=file", "Geometry/Mesh file=patch.msh",
       "Geometry/Global refinement=0", "Geometry/Element degree=" + std::to_string(order),
       "Material/Young's modulus=" + exact(E), "Material/Poisson ratio=" + exact(nu),
       "Boundary conditions/Contact boundary=bottom",
       "Boundary conditions/Prescribed displacement=top : " +
         turned(shift * cx, shift * cy, -epsilon),
       "Boundary conditions/Traction=left : " + turned(-sxx, 0, -sxz) +
         " | right : " + turned(sxx, 0, sxz) + " | front : " + turned(0, -sxx, -syz) +
         " | back : " + turned(0, sxx, syz),
       "Friction/Coefficient=" + exact(mu), "Contact solver/Tolerance=1e-11",
       "Contact solver/Method=" + method});

    double error_u = 0., error_force = 0.;
    for (const auto &node : run.problem->elasticity().body().locally_owned_nodes())
      {
        const double z = (transpose(R) * Tensor<1, 3>(node.position))[2];
        const Tensor<1, 3> exact_u =
          R * Tensor<1, 3>({cx * (gamma * z + s), cy * (gamma * z + s), -epsilon * z});
        for (unsigned int c = 0; c < 3; ++c)
          error_u = std::max(
            error_u, std::abs(run.problem->state().u(node.dofs[c]) - exact_u[c]) / shift);
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
    out() << title << ", order " << order << ", " << method << ", "
          << (sticks ? "stick" : "slip") << ": certified " << yes(run.converged)
          << ", displacement exact to 1e-8 " << yes(error_u < 1e-8)
          << ", contact forces exact to 1e-8 " << yes(error_force < 1e-8)
          << ", contact area " << surface.boundary_area() << std::endl;
  }

  // Force that presses a sphere by a given way into the unit cube.
  double force_on_sphere(const char kind, const unsigned int n,
                         const std::string &method = "newton")
  {
    CutBlockFile(
      {{n, n, n}}, [&](const auto &) { return kind; },
      [](const Point<3> &p) { return p; }, 1)
      .write("cube.msh");
    const Run run(
      shipped("sphere.prm"),
      {"Geometry/Type=file", "Geometry/Mesh file=cube.msh",
       "Geometry/Subdivisions=", "Geometry/Lengths=", "Geometry/Global refinement=0",
       "Boundary conditions/Prescribed displacement=bottom : 0; 0; 0",
       "Boundary conditions/Obstacle=sphere : 0.5; 0.5; 2.96; 2",
       "Contact solver/Method=" + method});
    out() << (run.converged ? "" : "NOT CERTIFIED ");
    return run.summary()["contact"]["force_on_body"][2].get<double>();
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using Place             = CutBlockFile::Place;
  const auto tetrahedra   = [](const Place &) { return 't'; };
  const auto both         = [](const Place &cube) { return cube[2] == 0 ? 't' : 'z'; };
  const Tensor<2, 3> flat = rotation(0., 0.), tilted = rotation(.7, -1.9);
  for (const bool sticks : {true, false})
    for (const std::string method : {"newton", "newton multigrid"})
      {
        patch("flat tetrahedra", tetrahedra, 1, method, flat, sticks);
        patch("tilted tetrahedra", tetrahedra, 1, method, tilted, sticks);
        patch("tilted tetrahedra and prisms", both, 1, method, tilted, sticks);
      }
  patch("flat tetrahedra", tetrahedra, 2, "newton", flat, false);
  patch("tilted tetrahedra and prisms", both, 2, "newton", tilted, false);

  const double reference = force_on_sphere('h', 16, "newton multigrid");
  const double coarse    = std::abs(force_on_sphere('t', 2) / reference - 1.);
  const double fine      = std::abs(force_on_sphere('t', 4) / reference - 1.);
  out() << "force on a sphere beside that of hexahedra a quarter as large: within 5 % "
        << yes(fine < .05) << ", nearer than with tetrahedra twice as large "
        << yes(fine < coarse) << std::endl;
}
