// Orthotropic and nearly incompressible materials. A block between a
// frictionless foundation and a top that comes down, with planes of symmetry
// through the contact face: the strain is uniform and known from the
// compliance. And that trilinear elements lock as nu approaches 0.5 where the
// volume strain is pointwise, and do not where it is the mean of a cell.

#include "several_bodies.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/physics/transformations.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace stiction;

namespace
{
  constexpr double height = 1., delta = 1e-3;

  // A material's text, and the strains along x, y, z for σ_zz = -1.
  void compress(const std::string &name, const std::vector<std::string> &material,
                const double strain_x, const double strain_y, const double strain_z)
  {
    const double p = delta / height / -strain_z;
    for (const char *const method :
         {"gauss seidel", "mpgp", "newton", "admm", "newton multigrid"})
      {
        std::vector<std::string> settings = {
          "Geometry/Table 1 level=0",
          "Geometry/Lengths=1.5,1.2,1",
          "Geometry/Subdivisions=2,2,2",
          "Geometry/Global refinement=1",
          "Boundary conditions/Prescribed displacement=top : free; free; " +
            exact(-delta) + " | left : 0; free; free | front : free; 0; free",
          "Boundary conditions/Traction=",
          "Friction/Law=frictionless",
          "Contact solver/Tolerance=1e-11",
          "Contact solver/Method=" + std::string(method)};
        settings.insert(settings.end(), material.begin(), material.end());
        const Run run(shipped("brick.prm"), settings);

        const auto &u          = run.problem->state().u;
        const double strains[] = {strain_x, strain_y, strain_z};
        double error_u = 0., error_p = 0.;
        for (const auto &node : run.problem->elasticity().body().locally_owned_nodes())
          for (unsigned int c = 0; c < 3; ++c)
            error_u = std::max(
              error_u,
              std::abs(u(node.dofs[c]) - p * strains[c] * node.position[c]) / delta);
        error_u = dealii::Utilities::MPI::max(error_u, MPI_COMM_WORLD);
        const ContactSurface &surface = run.problem->contact_surface();
        for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
          error_p = std::max(error_p, std::abs(run.problem->certificate().lambda()(i) /
                                                 surface.areas()(i) / p -
                                               1.));
        out() << name << ", " << method << ": certified " << yes(run.converged)
              << ", displacement exact to 1e-8 " << yes(error_u < 1e-8)
              << ", pressure exact to 1e-8 " << yes(error_p < 1e-8) << '\n';
      }
  }

  // Whether wood pressed and dragged on a plane bears the same where body, grain, plane
  // and loads are turned together, by 40 degrees about (1, 2, 2).
  void turned(const std::string &method)
  {
    const dealii::Tensor<2, 3> turn =
      dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
        dealii::Point<3>(1. / 3., 2. / 3., 2. / 3.), 40. * dealii::numbers::PI / 180.);
    const auto run_turned = [&](const std::string &name, const dealii::Tensor<2, 3> &R,
                                const std::string &angle) {
      const auto along = [&](const double x, const double y, const double z) {
        const dealii::Tensor<1, 3> v = R * dealii::Tensor<1, 3>({x, y, z});
        return three(v[0], v[1], v[2]);
      };
      return std::make_unique<Run>(
        file(name,
             section("Body block", {"Lengths = 3,2,1", "Subdivisions = 4,3,2",
                                    "Rotation = 0;0;0;1;2;2;" + angle}) +
               section("Material", {"Materials = 0 : orthotropic; 11000; 900; 500; 0.38; "
                                    "0.42; 0.48; 700; 650; 40; " +
                                    along(1., 0.5, 0.2) + ";" + along(0., 1., 0.)}) +
               section("Boundary conditions",
                       {"Traction = block.top : " + along(0.2, 0., -1.)}) +
               section("Contact pair below",
                       {"Boundary = block.bottom",
                        "Obstacle = plane : 0;0;0;" + along(0., 0., 1.), "Law = coulomb",
                        "Coefficient = 0.3"})),
        Settings{"Contact solver/Method=" + method, "Contact solver/Tolerance=1e-11"});
    };
    dealii::Tensor<2, 3> unit;
    for (unsigned int c = 0; c < 3; ++c)
      unit[c][c] = 1.;
    const auto straight   = run_turned("straight.prm", unit, "0"),
               run        = run_turned("turned.prm", turn, "40");
    const auto &expected  = straight->problem->contact_surface(),
               &surface   = run->problem->contact_surface();
    const auto &lambda    = straight->problem->state().lambda,
               &of_turned = run->problem->state().lambda;
    const Eigen::Index m  = expected.n_nodes();
    const auto slips      = [&](const Run &of) {
      return of.summary()["contact"]["slip"].template get<int>();
    };
    double error   = 0.;
    unsigned int n = 0;
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < m; ++j)
        if (surface.nodes()[j].position.distance(
              dealii::Point<3>(turn * expected.nodes()[i].position)) < 1e-9)
          {
            ++n;
            error =
              std::max({error, std::abs(lambda(i) - of_turned(j)),
                        std::abs(std::hypot(lambda(i + m), lambda(i + 2 * m)) -
                                 std::hypot(of_turned(j + m), of_turned(j + 2 * m)))});
          }
    out() << "turned, " << method << ": certified "
          << yes(straight->converged && run->converged) << ", sticks and slips "
          << yes(slips(*run) > 0 && slips(*run) < m) << ", the same to 1e-8 "
          << yes(n == m && error < 1e-8 * lambda.lpNorm<Eigen::Infinity>()) << '\n';
  }

  double deflection(const std::string &volume_strain, const std::string &degree)
  {
    const Run run(shipped("brick.prm"),
                  {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                   "Geometry/Subdivisions=4,3,1", "Geometry/Global refinement=1",
                   "Geometry/Element degree=" + degree, "Material/Poisson ratio=0.4999",
                   "Material/Volume strain=" + volume_strain,
                   "Contact solver/Method=newton"});
    return run.summary()["displacement"]["max"].get<double>();
  }

  // A sphere in a block with nu = 0.499, elements of degree 2.
  double force_on_rubber(const std::string &volume_strain,
                         const std::string &subdivisions)
  {
    const Run run(shipped("rubber.prm"),
                  {"Geometry/Element degree=2", "Geometry/Global refinement=0",
                   "Geometry/Subdivisions=" + subdivisions,
                   "Material/Volume strain=" + volume_strain});
    return run.summary()["contact"]["force_on_body"][2].get<double>();
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // strains for σ_zz = -1 from the third column of the compliance
  const double E1 = 11e9, E2 = 0.9e9, E3 = 0.5e9, nu13 = 0.42, nu23 = 0.48;
  compress("orthotropic",
           {"Material/Materials=0 : orthotropic; 11e9; 0.9e9; 0.5e9; 0.38; "
            "0.42; 0.48; 0.7e9; 0.65e9; 0.04e9"},
           nu13 / E1, nu23 / E2, -1. / E3);
  compress("along the grain",
           {"Material/Materials=0 : orthotropic; 11e9; 0.9e9; 0.5e9; 0.38; "
            "0.42; 0.48; 0.7e9; 0.65e9; 0.04e9; 0; 0; 2; 1; 0; 1"},
           0.38 / E1, nu13 / E1, -1. / E1);
  for (const char *const method : {"newton", "newton multigrid"})
    turned(method);
  const double E = 3e6, nu = 0.4999;
  compress("nearly incompressible",
           {"Material/Young's modulus=3e6", "Material/Poisson ratio=0.4999",
            "Material/Volume strain=cell mean"},
           nu / E, nu / E, -1. / E);
  compress("nearly incompressible, degree 2",
           {"Material/Young's modulus=3e6", "Material/Poisson ratio=0.49",
            "Geometry/Element degree=2"},
           0.49 / E, 0.49 / E, -1. / E);

  const double pointwise = deflection("pointwise", "1");
  const double mean      = deflection("cell mean", "1");
  const double automatic = deflection("automatic", "1");
  const double quadratic = deflection("cell mean", "2");
  out() << "locking: pointwise more than a tenth too stiff "
        << yes(pointwise < 0.9 * quadratic) << ", cell mean within 2 % of degree 2 "
        << yes(std::abs(mean / quadratic - 1.) < 0.02)
        << ", which is what automatic takes "
        << yes(std::abs(automatic / mean - 1.) < 1e-12) << '\n';
  const double fine = force_on_rubber("automatic", "6,6,4");
  out() << "degree 2 on a coarse mesh: pointwise more than a fifth too stiff "
        << yes(force_on_rubber("pointwise", "3,3,2") < 1.2 * fine)
        << ", linear volume strains, which automatic takes, within 2 % of a finer one "
        << yes(std::abs(force_on_rubber("automatic", "3,3,2") / fine - 1.) < 0.02)
        << '\n';
}
