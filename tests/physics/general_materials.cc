// Orthotropic and nearly incompressible materials. A block between a
// frictionless foundation and a top that comes down, with planes of symmetry
// through the contact face: the strain is uniform and known from the
// compliance. And that trilinear elements lock as nu approaches 0.5 where the
// volume strain is pointwise, and do not where it is the mean of a cell.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <cmath>

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
  const double E = 3e6, nu = 0.4999;
  compress("nearly incompressible",
           {"Material/Young's modulus=3e6", "Material/Poisson ratio=0.4999",
            "Material/Volume strain=cell mean"},
           nu / E, nu / E, -1. / E);

  const double pointwise = deflection("pointwise", "1");
  const double mean      = deflection("cell mean", "1");
  const double automatic = deflection("automatic", "1");
  const double quadratic = deflection("cell mean", "2");
  out() << "locking: pointwise more than a tenth too stiff "
        << yes(pointwise < 0.9 * quadratic) << ", cell mean within 2 % of degree 2 "
        << yes(std::abs(mean / quadratic - 1.) < 0.02)
        << ", which is what automatic takes "
        << yes(std::abs(automatic / mean - 1.) < 1e-12) << '\n';
}
