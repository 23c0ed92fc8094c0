// Bodies of several materials, and loads of every kind, with exact solutions
// that are linear in each layer, or quadratic along z: then without lateral
// contraction trilinear elements are exact at the nodes.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/tensor_json.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

using namespace stiction;

namespace
{
  using Displacement = std::function<std::array<double, 3>(const dealii::Point<3> &)>;

  constexpr double p = 3e7; // Pa

  // A frictionless brick of 1.5 m × 1.2 m × 1 m on the foundation.
  std::vector<std::string> brick(const std::vector<std::string> &settings)
  {
    std::vector<std::string> all = {
      "Geometry/Lengths=1.5,1.2,1",    "Geometry/Table 1 level=0",
      "Geometry/Subdivisions=2,2,2",   "Geometry/Global refinement=1",
      "Boundary conditions/Traction=", "Friction/Law=frictionless",
      "Contact solver/Tolerance=1e-11"};
    all.insert(all.end(), settings.begin(), settings.end());
    return all;
  }

  // The largest errors of the displacement and of the pressure, relative; the
  // pressure is that of all nodes unless it is 0.
  void check(const std::string &what, const Run &run, const double displacement,
             const Displacement &exact_u, const double pressure, const double force)
  {
    const auto &u = run.problem->state().u;
    double error  = 0.;
    for (const auto &node : run.problem->elasticity().body().locally_owned_nodes())
      {
        const auto expected = exact_u(node.position);
        for (unsigned int c = 0; c < 3; ++c)
          error = std::max(error, std::abs(u(node.dofs[c]) - expected[c]));
      }
    error = dealii::Utilities::MPI::max(error, MPI_COMM_WORLD) / displacement;

    const auto &surface  = run.problem->contact_surface();
    const auto &lambda   = run.problem->state().lambda;
    const Eigen::Index m = surface.n_nodes();
    double error_p       = 0.;
    for (Eigen::Index i = 0; i < m && pressure > 0.; ++i)
      error_p =
        std::max(error_p, std::abs(lambda(i) / surface.nodes()[i].area / pressure - 1.));
    const double error_f = std::abs(lambda.head(m).sum() / force - 1.);
    out() << what << ": certified " << yes(run.converged)
          << ", displacement exact to 1e-8 " << yes(error < 1e-8)
          << ", pressure exact to 1e-8 " << yes(error_p < 1e-8)
          << ", force exact to 1e-8 " << yes(error_f < 1e-8) << std::endl;
  }

  void layers(const std::string &method)
  {
    // a soft layer below a stiff one, both pressed together
    constexpr double E0 = 2e9, E1 = 2e11;
    const double delta = p * (0.5 / E0 + 0.5 / E1);
    const Run stack(
      shipped("brick.prm"),
      brick({"Contact solver/Method=" + method, "Material/Material ids=if(z < 0.5, 0, 7)",
             "Material/Poisson ratio=0",
             "Material/Materials=0 : isotropic; 2e9; 0 | 7 : "
             "isotropic; 2e11; 0",
             "Boundary conditions/Prescribed displacement=top : "
             "0; 0; " +
               exact(-delta)}));
    check(
      method + ", soft below stiff", stack, delta,
      [&](const auto &x) -> std::array<double, 3> {
        return {
          {0., 0., -p * (std::min(x[2], 0.5) / E0 + std::max(x[2] - 0.5, 0.) / E1)}};
      },
      p, 1.8 * p);

    // side by side: the same strain, so another stress
    const Run sides(
      shipped("brick.prm"),
      brick({"Contact solver/Method=" + method,
             "Material/Material ids=if(x < 0.75, 1, 2)", "Material/Young's modulus=1e11",
             "Material/Poisson ratio=0", "Material/Materials=2 : isotropic; 2.5e10; 0",
             "Boundary conditions/Prescribed displacement=top : "
             "0; 0; -1e-4"}));
    check(
      method + ", side by side", sides, 1e-4,
      [](const auto &x) -> std::array<double, 3> {
        return {{0., 0., -1e-4 * x[2]}};
      },
      0., 0.75 * 1.2 * 1e-4 * (1e11 + 2.5e10));
  }

  void weight(const std::string &method)
  {
    // u_z = -ρg(zH - z²/2)/E; the top is held where it hangs free anyway
    constexpr double rho = 5e4, E = 1e7, g = 10.;
    const auto u_z     = [](const double z) { return -rho * g * (z - z * z / 2.) / E; };
    const auto hanging = [&](const std::string &name, const std::string &load,
                             const std::string &density) {
      const Run run(
        shipped("brick.prm"),
        brick({"Contact solver/Method=" + method, "Material/Young's modulus=" + exact(E),
               "Material/Poisson ratio=0", load, density, "Boundary conditions/Time=2.5",
               "Boundary conditions/Prescribed displacement=top : 0; 0; " +
                 exact(u_z(1.) / 2.5) + "*t"}));
      check(
        method + ", " + name, run, -u_z(1.),
        [&](const auto &x) -> std::array<double, 3> {
          return {{0., 0., u_z(x[2])}};
        },
        rho *g, 1.8 * rho * g);
    };
    hanging("weight", "Boundary conditions/Gravity=0; 0; -10", "Material/Density=5e4");
    hanging("weight that grows with t", "Boundary conditions/Gravity=0; 0; -4*t",
            "Material/Densities=0 : 5e4");
    hanging("body force", "Boundary conditions/Body force=0; 0; -2e5*t",
            "Material/Density=0");
  }

  void hydrostatic(const std::string &method)
  {
    // On one side twice the pressure and a traction that takes half of it away,
    // on another one half as traction.
    constexpr double E = 2e11, nu = 0.3;
    const double k = p * (1. - 2. * nu) / E;
    const Run run(
      shipped("brick.prm"),
      brick({"Contact solver/Method=" + method, "Material/Young's modulus=" + exact(E),
             "Material/Poisson ratio=" + exact(nu), "Boundary conditions/Time=3",
             "Boundary conditions/Pressure=left : 3e7 | right : 6e7 "
             "| front : 1e7*t | back : 1.5e7",
             "Boundary conditions/Traction=right : 3e7; 0; 0 | "
             "back : 0; -0.5e7*t; 0",
             "Boundary conditions/Prescribed displacement=top : " + exact(-k) + "*x; " +
               exact(-k) + "*y; " + exact(-k)}));
    check(
      method + ", pressure from all sides", run, k,
      [&](const auto &x) -> std::array<double, 3> {
        return {{-k * x[0], -k * x[1], -k * x[2]}};
      },
      p, 1.8 * p);
  }

  // What is given as a formula of t is what stands for it.
  void all_formulas_know_t()
  {
    const auto force = [](const std::string &gap, const std::string &friction,
                          const std::string &time) {
      const Run run(
        shipped("brick.prm"),
        brick({"Contact solver/Method=newton", "Contact solver/Tolerance=1e-8",
               "Friction/Law=coulomb", "Friction/Coefficient=" + friction,
               "Boundary conditions/Initial gap=" + gap,
               "Boundary conditions/Time=" + time,
               "Boundary conditions/Prescribed displacement=top : "
               "2e-4; 0; -1e-4"}));
      return run.summary()["contact"]["force_on_body"].get<dealii::Tensor<1, 3>>();
    };
    const auto steady = force("-1e-4", "0.2", "7");
    const auto moving = force("-2e-4*t", "0.1/t", "0.5");
    out() << "gap and friction of t: the same force to 1e-10 "
          << yes((steady - moving).norm() < 1e-10 * steady.norm()) << ", which is one "
          << yes(steady.norm() > 1e6) << std::endl;
  }

  // Uniaxial and shear stresses give the strains that the nine numbers say.
  void orthotropic_tensor()
  {
    const std::array<double, 9> numbers = {{10., 8., 2., 0.3, 0.4, 0.25, 3., 1.5, 0.7}};
    const double *const E = &numbers[0], *const nu = &numbers[3], *const G = &numbers[6];
    const auto material        = Material::orthotropic(numbers);
    const double strains[6][6] = {// ε11, ε22, ε33, ε12, ε13, ε23 of unit stresses
                                  {1. / E[0], -nu[0] / E[0], -nu[1] / E[0], 0., 0., 0.},
                                  {-nu[0] / E[0], 1. / E[1], -nu[2] / E[1], 0., 0., 0.},
                                  {-nu[1] / E[0], -nu[2] / E[1], 1. / E[2], 0., 0., 0.},
                                  {0., 0., 0., 0.5 / G[0], 0., 0.},
                                  {0., 0., 0., 0., 0.5 / G[1], 0.},
                                  {0., 0., 0., 0., 0., 0.5 / G[2]}};
    const unsigned int rows[] = {0, 1, 2, 0, 0, 1}, columns[] = {0, 1, 2, 1, 2, 2};
    double error = 0.;
    for (unsigned int k = 0; k < 6; ++k)
      {
        dealii::SymmetricTensor<2, 3> strain, expected;
        for (unsigned int l = 0; l < 6; ++l)
          strain[rows[l]][columns[l]] = strains[k][l];
        expected[rows[k]][columns[k]] = 1.;
        error = std::max(error, (material.stress(strain) - expected).norm());
      }
    // isotropic numbers make the isotropic tensor
    const auto steel = Material::isotropic(2., 0.3);
    const double g   = 2. / 2.6;
    const auto same  = Material::orthotropic({{2., 2., 2., 0.3, 0.3, 0.3, g, g, g}});
    bool is_refused  = false;
    try
      {
        Material::orthotropic({{1., 1., 1., 0.5, 0.5, 0.5, 1., 1., 1.}});
      }
    catch (const std::domain_error &)
      {
        is_refused = true;
      }
    out() << "orthotropic: strains of unit stresses to 1e-14 " << yes(error < 1e-14)
          << ", isotropic numbers give that tensor "
          << yes((steel.stiffness - same.stiffness).norm() < 1e-14)
          << ", no volume stiffness is refused " << yes(is_refused) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string method : {"gauss seidel", "newton multigrid"})
    {
      layers(method);
      weight(method);
      hydrostatic(method);
    }
  all_formulas_know_t();
  orthotropic_tensor();
}
