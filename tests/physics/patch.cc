// Patch tests: a brick pressed onto the foundation and sheared, with the exact
// solution linear in space, so that trilinear elements reproduce it. Stick
// and slip, both laws of friction, directions of shear that are no axis. If
// the shear reaches the bound, all of the face slips by the same s.

#include "tests.h"

#include <stiction/elasticity/body.h>
#include <stiction/elasticity/linear_elasticity.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>

using namespace stiction;

namespace
{
  constexpr double E = 2e11, nu = 0.3, epsilon = 1e-4, height = 1.;

  std::string
  three(const double x, const double y, const double z)
  {
    return exact(x) + ";" + exact(y) + ";" + exact(z);
  }

  // The largest error of displacement and contact force, relative.
  void
  patch(const std::string &method,
        const std::string &law,
        const std::string &ending,
        const double shift,
        const double degrees)
  {
    const double lame  = E * nu / ((1. + nu) * (1. - 2. * nu));
    const double G     = E / (2. * (1. + nu));
    const double p     = (lame + 2. * G) * epsilon;
    const double mu    = 0.25;
    const double bound = law == "coulomb" ? mu * p : 0.2 * p;

    const bool sticks  = G * shift / height <= bound;
    const double gamma = sticks ? shift / height : bound / G;
    const double s     = shift - gamma * height;
    const double angle = degrees / 180. * dealii::numbers::PI;
    const double cx = std::cos(angle), cy = std::sin(angle);

    // tractions σn of the side faces
    const double sxx = -lame * epsilon;
    const double sxz = G * gamma * cx, syz = G * gamma * cy;
    const Run run(shipped("brick.prm"),
                  {"Geometry/Table 1 level=0",
                   "Geometry/Lengths=1.5,1.2,1",
                   "Geometry/Subdivisions=3,2,2",
                   "Geometry/Global refinement=1",
                   "Material/Young's modulus=" + exact(E),
                   "Material/Poisson ratio=" + exact(nu),
                   "Boundary conditions/Prescribed displacement=5 : " +
                     three(shift * cx, shift * cy, -epsilon * height),
                   "Boundary conditions/Traction=0 : " + three(-sxx, 0, -sxz) +
                     " | 1 : " + three(sxx, 0, sxz) + " | 2 : " +
                     three(0, -sxx, -syz) + " | 3 : " + three(0, sxx, syz),
                   "Contact solver/Method=" + method,
                   "Friction/Law=" + law,
                   "Friction/Coefficient=" + exact(mu),
                   "Friction/Slip stress=" + exact(0.2 * p),
                   "Contact solver/Tolerance=1e-11"});

    const auto &u  = run.problem->displacement();
    double error_u = 0., error_lambda = 0.;
    for (const auto &node :
         run.problem->elasticity().body().locally_owned_nodes())
      {
        const double z         = node.position[2];
        const double exact_u[] = {
          cx * (gamma * z + s), cy * (gamma * z + s), -epsilon * z};
        for (unsigned int c = 0; c < 3; ++c)
          error_u =
            std::max(error_u, std::abs(u(node.dofs[c]) - exact_u[c]) / shift);
      }
    error_u = dealii::Utilities::MPI::max(error_u, MPI_COMM_WORLD);

    const auto &surface       = run.problem->contact_surface();
    const auto &lambda        = run.problem->solution().lambda;
    const Eigen::Index m      = surface.n_nodes();
    unsigned int right_status = 0;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const auto &node       = surface.nodes()[i];
        const double exact_l[] = {
          p * node.area,
          G * gamma * node.area *
            (cx * node.tangent1[0] + cy * node.tangent1[1]),
          G * gamma * node.area *
            (cx * node.tangent2[0] + cy * node.tangent2[1])};
        for (unsigned int c = 0; c < 3; ++c)
          error_lambda = std::max(error_lambda,
                                  std::abs(lambda(i + c * m) - exact_l[c]) /
                                    (p * node.area));
        right_status += run.problem->certificate().status(i) ==
                            (sticks ? NodeStatus::stick : NodeStatus::slip)
                          ? 1
                          : 0;
      }

    out() << method << ", " << law << ", " << degrees
          << " degrees, expected to " << ending << ": certified "
          << yes(run.converged) << ", all nodes " << ending << " "
          << yes(right_status == m && sticks == (ending == "stick"))
          << ", displacement exact to 1e-8 " << yes(error_u < 1e-8)
          << ", contact forces exact to 1e-8 " << yes(error_lambda < 1e-8)
          << std::endl;
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string method : {"gauss seidel", "newton multigrid"})
    for (const std::string law : {"given", "coulomb"})
      for (const double degrees : {0., 30., 90., 137., 250.})
        {
          patch(method, law, "stick", 3e-5, degrees);
          patch(method, law, "slip", 2e-4, degrees);
        }
}
