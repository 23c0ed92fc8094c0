#pragma once

// Patch tests: a brick pressed onto the foundation and sheared, with the exact
// solution linear in space, so that all elements reproduce it. If the shear
// reaches the bound, all of the face slips by the same s.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>

struct Patch
{
  bool certified, ends_as_expected;
  double displacement_error, force_error; // the largest, relative
  double energy_error;                    // of the balance, relative
  double area_error;                      // of the sum of nodal areas, relative
  bool has_hanging_nodes;
};

// The brick of 1.5 m x 1.2 m x 1 m, its top shifted in a direction that is
// given in degrees; settings are those of mesh and solver.
inline Patch solve_patch(std::vector<std::string> settings, const std::string &law,
                         const std::string &ending, const double shift,
                         const double degrees)
{
  constexpr double E = 2e11, nu = 0.3, epsilon = 1e-4, height = 1.;

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
  for (const std::string &setting :
       {std::string("Geometry/Table 1 level=0"),
        std::string("Geometry/Lengths=1.5,1.2,1"), "Material/Young's modulus=" + exact(E),
        "Material/Poisson ratio=" + exact(nu),
        "Boundary conditions/Prescribed displacement=5 : " +
          three(shift * cx, shift * cy, -epsilon * height),
        "Boundary conditions/Traction=0 : " + three(-sxx, 0, -sxz) +
          " | 1 : " + three(sxx, 0, sxz) + " | 2 : " + three(0, -sxx, -syz) +
          " | 3 : " + three(0, sxx, syz),
        "Friction/Law=" + law, "Friction/Coefficient=" + exact(mu),
        "Friction/Slip stress=" + exact(0.2 * p)})
    settings.push_back(setting);
  const Run run(shipped("brick.prm"), settings);

  const stiction::Body &body = run.problem->elasticity().body();
  const auto &u              = run.problem->state().u;
  Patch patch{};
  patch.certified         = run.converged;
  patch.has_hanging_nodes = body.n_hanging_nodes() > 0;
  double error            = 0.;
  for (const auto &node : body.locally_owned_nodes())
    {
      const double z         = node.position[2];
      const double exact_u[] = {cx * (gamma * z + s), cy * (gamma * z + s), -epsilon * z};
      for (unsigned int c = 0; c < 3; ++c)
        error = std::max(error, std::abs(u(node.dofs[c]) - exact_u[c]) / shift);
    }
  patch.displacement_error = dealii::Utilities::MPI::max(error, MPI_COMM_WORLD);

  const auto &surface       = run.problem->contact_surface();
  const auto &lambda        = run.problem->state().lambda;
  const Eigen::Index m      = surface.n_nodes();
  const auto statuses       = run.problem->node_statuses();
  unsigned int right_status = 0;
  for (Eigen::Index i = 0; i < m; ++i)
    {
      const auto &node       = surface.nodes()[i];
      const double exact_l[] = {
        p * node.area,
        G * gamma * node.area * (cx * node.tangent1[0] + cy * node.tangent1[1]),
        G * gamma * node.area * (cx * node.tangent2[0] + cy * node.tangent2[1])};
      for (unsigned int c = 0; c < 3; ++c)
        patch.force_error = std::max(
          patch.force_error, std::abs(lambda(i + c * m) - exact_l[c]) / (p * node.area));
      right_status +=
        statuses[i].normal == stiction::NormalStatus::closed &&
            statuses[i].tangential == (sticks ? stiction::TangentialStatus::stick
                                              : stiction::TangentialStatus::slip)
          ? 1
          : 0;
    }
  patch.ends_as_expected = right_status == m && sticks == (ending == "stick");
  patch.area_error       = std::abs(surface.areas().sum() / 1.8 - 1.);

  const auto &energy = run.summary()["energy"];
  patch.energy_error = std::abs(
    (2. * energy["strain"].get<double>() + energy["friction_dissipation"].get<double>()) /
      energy["load_work"].get<double>() -
    1.);
  return patch;
}
