// The largest pressure on cut tetrahedra is one node's, here at the rim of the contact;
// over the faces around a node it is nearly that of Hertz. Pressures that are the same
// everywhere are so around each node.

#include "cut_block_file.h"
#include "tests.h"

#include <stiction/output/results/nodal_values.h>

#include <deal.II/base/numbers.h>

#include <cmath>

using dealii::Point;

namespace
{
  constexpr double E = 2e5, nu = 0.3, R = 1.;

  // A frictionless rigid sphere presses on the top of a block, whose cells are the
  // smaller the nearer they are to the middle of its top.
  void press()
  {
    const auto towards_middle = [](const double q) {
      const double t = 2. * q - 1.;
      return 0.5 + 0.5 * t * (0.2 + 0.8 * t * t);
    };
    CutBlockFile(
      {{8, 8, 8}}, [&](const auto &) { return 't'; },
      [&](const Point<3> &q) {
        Point<3> p = q; // no two cells are alike, its boundary stays where it is
        for (unsigned int d = 0; d < 3; ++d)
          p[d] +=
            0.02 *
            std::sin(2. + 50. * q[d] + 70. * q[(d + 1) % 3] + 90. * q[(d + 2) % 3]) *
            (q[d] == 0. || q[d] == 1. ? 0. : 1.);
        return Point<3>(towards_middle(p[0]), towards_middle(p[1]),
                        towards_middle(0.5 + 0.5 * p[2]) - 1.);
      },
      1)
      .write("block.msh");
    const Run run("",
                  {"Geometry/Type=file", "Geometry/Mesh file=block.msh",
                   "Geometry/Global refinement=1", "Material/Young's modulus=" + exact(E),
                   "Material/Poisson ratio=" + exact(nu),
                   "Boundary conditions/Prescribed displacement=bottom : 0; 0; 0",
                   "Boundary conditions/Contact boundary=top",
                   "Boundary conditions/Obstacle=sphere : 0.5; 0.5; 0.99; 1",
                   "Contact solver/Method=newton multigrid", "Friction/Law=frictionless",
                   "Output/Write solution=false"});
    const auto contact   = run.summary()["contact"];
    const double force   = -contact["force_on_body"][2].get<double>();
    const double modulus = E / (1. - nu * nu);
    const double hertz =
      std::cbrt(6. * force * modulus * modulus / (R * R)) / dealii::numbers::PI;
    const double max    = contact["max_pressure"].get<double>() / hertz,
                 around = contact["max_mean_pressure"].get<double>() / hertz;
    out() << "certified " << yes(run.converged)
          << ", largest pressure over the faces around a node within 7 % of Hertz "
          << yes(std::abs(around - 1.) < 0.07) << ", nearer than that of a node "
          << yes(std::abs(around - 1.) < std::abs(max - 1.)) << std::endl;

    const auto &surface        = run.problem->contact_surface();
    const Eigen::VectorXd same = stiction::pressure_around(
      run.problem->elasticity().body(), surface, 3. * surface.areas());
    out() << "the same everywhere remains so "
          << yes((same.array() / 3. - 1.).abs().maxCoeff() < 1e-13) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  press();
}
