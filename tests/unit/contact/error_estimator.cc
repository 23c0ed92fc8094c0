// The error estimator: it finds nothing where the discrete solution is exact,
// hanging nodes, friction and the curvature of quadratic displacements
// included; it finds something where stress, contact forces or the obstacle
// are not what they should be; it tends to the error; and a sample of the cells
// says the same as all of them.

#include "tests.h"

#include <stiction/contact/interface/state.h>
#include <stiction/contact/certificate/error_estimator.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <cmath>

using namespace stiction;
using dealii::Point;

namespace
{
  constexpr double E = 2e11, nu = 0.3, epsilon = 1e-4;
  constexpr double lame = E * nu / ((1. + nu) * (1. - 2. * nu));
  constexpr double G    = E / (2. * (1. + nu));

  // η of a solution with other contact forces.
  double estimate(const Run &run, const Eigen::VectorXd &lambda)
  {
    const ContactProblem &problem        = *run.problem;
    const dealii::Vector<double> squares = estimate_error(
      problem.elasticity(), problem.contact_surface(), {problem.state().u, lambda, {}});
    double sum = 0.;
    for (const double square : squares)
      sum += square;
    return std::sqrt(dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD));
  }

  double estimate(const Run &run) { return estimate(run, run.problem->state().lambda); }

  double energy_norm(const Run &run)
  {
    return std::sqrt(2. * run.problem->certificate().strain_energy());
  }

  // The work of the pressure across a gap is linear in it: η shows the root of
  // rounding.
  bool is_nothing(const double eta, const double norm)
  {
    return eta * eta < 1e-12 * norm * norm;
  }

  // A brick pressed onto the foundation and sheared (see physics/patch.cc).
  void patch(const std::string &ending, const double shift,
             const std::vector<std::string> &mesh)
  {
    const double p = (lame + 2. * G) * epsilon, mu = 0.25;
    const double gamma = ending == "stick" ? shift : mu * p / G;
    const double angle = 0.5, cx = std::cos(angle), cy = std::sin(angle);
    const double sxx = -lame * epsilon;
    const double sxz = G * gamma * cx, syz = G * gamma * cy;

    std::vector<std::string> settings = {
      "Geometry/Table 1 level=0",
      "Geometry/Lengths=1.5,1.2,1",
      "Geometry/Subdivisions=3,2,2",
      "Geometry/Global refinement=1",
      "Material/Young's modulus=" + exact(E),
      "Material/Poisson ratio=" + exact(nu),
      "Boundary conditions/Prescribed displacement=5 : " +
        three(shift * cx, shift * cy, -epsilon),
      "Boundary conditions/Traction=0 : " + three(-sxx, 0, -sxz) +
        " | 1 : " + three(sxx, 0, sxz) + " | 2 : " + three(0, -sxx, -syz) +
        " | 3 : " + three(0, sxx, syz),
      "Friction/Coefficient=" + exact(mu),
      "Contact solver/Method=newton",
      "Contact solver/Tolerance=1e-11"};
    settings.insert(settings.end(), mesh.begin(), mesh.end());
    const Run run(shipped("brick.prm"), settings);
    const double norm = energy_norm(run);

    Eigen::VectorXd wrong = run.problem->state().lambda;
    wrong(0) *= 1.01;
    out() << "patch, " << ending << ", hanging nodes "
          << (run.problem->elasticity().body().n_hanging_nodes() > 0 ? "yes" : "no")
          << ": certified " << yes(run.converged) << ", nothing to find "
          << yes(is_nothing(estimate(run), norm))
          << ", sees one per cent of one contact force "
          << yes(estimate(run, wrong) > 1e-5 * norm) << std::endl;
  }

  // Bending in the plane of the foundation under uniform pressure: σ_xx = c y,
  // σ_zz = −p.
  constexpr double c = 1e7, p = 2e7;

  std::string bent()
  {
    const std::string u = "x*(" + exact(c / E) + "*y + " + exact(nu * p / E) + "); " +
                          exact(-c / (2. * E)) + "*(x^2 + " + exact(nu) +
                          "*(y^2 - z^2)) + " + exact(nu * p / E) + "*y; -z*(" +
                          exact(nu * c / E) + "*y + " + exact(p / E) + ")";
    std::string all;
    for (const char *face : {"left", "right", "front", "back", "top"})
      all += (all.empty() ? "" : " | ") + std::string(face) + " : " + u;
    return all;
  }

  // ‖u_h − u‖ in the energy norm
  double error_of_bending(const Run &run)
  {
    using namespace dealii;
    const Body &body = run.problem->elasticity().body();
    LA::Vector u(body.locally_owned_dofs(), body.locally_relevant_dofs(), MPI_COMM_WORLD);
    u = run.problem->state().u;
    u.update_ghost_values();
    const QGauss<3> quadrature(3);
    FEValues<3> values(body.mapping(), body.dof_handler().get_fe(), quadrature,
                       update_gradients | update_quadrature_points | update_JxW_values);
    const FEValuesExtractors::Vector displacement(0);
    std::vector<SymmetricTensor<2, 3>> strains(quadrature.size());
    double sum = 0.;
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          values.reinit(cell);
          values[displacement].get_function_symmetric_gradients(u, strains);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const double y               = values.quadrature_point(q)[1];
              SymmetricTensor<2, 3> strain = strains[q];
              strain[0][0] -= (c * y + nu * p) / E;
              strain[1][1] -= nu * (p - c * y) / E;
              strain[2][2] -= (-nu * c * y - p) / E;
              sum += (lame * trace(strain) * trace(strain) + 2. * G * (strain * strain)) *
                     values.JxW(q);
            }
        }
    return std::sqrt(Utilities::MPI::sum(sum, MPI_COMM_WORLD));
  }

  void bending()
  {
    double last_error = 0., last_estimate = 0.;
    for (const std::string mesh : {"cell mean", "1", "2", "3", "quadratic",
                                   "quadratic, linear volume strains", "curved"})
      {
        const bool is_projected = mesh == "quadratic, linear volume strains";
        const bool has_mean     = mesh == "cell mean";
        const bool is_exact     = mesh == "quadratic" || is_projected;
        const bool is_quadratic = is_exact || mesh == "curved";
        const Run run(
          shipped("brick.prm"),
          {"Geometry/Table 1 level=0", "Geometry/Lengths=1,1,1",
           "Geometry/Subdivisions=2,2,2",
           "Geometry/Global refinement=" + (is_quadratic ? "0"
                                            : has_mean   ? "2"
                                                         : mesh),
           std::string("Material/Volume strain=") +
             (has_mean || is_projected ? "cell mean" : "pointwise"),
           std::string("Geometry/Element degree=") + (is_quadratic ? "2" : "1"),
           "Material/Young's modulus=" + exact(E), "Material/Poisson ratio=" + exact(nu),
           "Boundary conditions/Prescribed displacement=" + bent(),
           "Boundary conditions/Traction=",
           // nothing at the nodes
           std::string("Boundary conditions/Initial gap=") +
             (mesh == "curved" ? "-1e-6*sin(4*pi*x)^2" : "0"),
           "Friction/Law=frictionless", "Contact solver/Method=newton",
           "Contact solver/Tolerance=1e-11"});
        const double eta = estimate(run), norm = energy_norm(run);
        const double error = error_of_bending(run);
        out() << "bending, mesh " << mesh << ": certified " << yes(run.converged);
        if (is_exact)
          out() << ", exact to 1e-9 " << yes(error < 1e-9 * norm) << ", nothing to find "
                << yes(is_nothing(eta, norm));
        else if (mesh == "curved")
          out() << ", sees an obstacle between the nodes " << yes(eta > 1e-3 * norm);
        else
          {
            out() << ", estimate within a sixth of the error "
                  << yes(std::abs(eta / error - 1.) < 1. / 6.);
            if (last_error > 0.)
              out() << ", error halved " << yes(std::abs(last_error / error - 2.) < 0.1)
                    << ", estimate halved "
                    << yes(std::abs(last_estimate / eta - 2.) < 0.2)
                    << ", ratio of both nearer to one "
                    << yes(std::abs(eta / error - 1.) <
                           0.6 * std::abs(last_estimate / last_error - 1.));
            if (!has_mean)
              {
                last_error    = error;
                last_estimate = eta;
              }
          }
        out() << std::endl;
      }
  }

  // A column between smooth walls and pressed from above, under its own weight:
  // quadratic elements are exact. Contact nodes at the walls are partly held.
  void weight()
  {
    const Run run(shipped("brick.prm"),
                  {"Geometry/Table 1 level=0", "Geometry/Lengths=1,1,1",
                   "Geometry/Subdivisions=2,2,2", "Geometry/Global refinement=0",
                   "Geometry/Element degree=2", "Material/Young's modulus=3e10",
                   "Material/Poisson ratio=0.2", "Material/Density=2400",
                   "Boundary conditions/Prescribed displacement=left : 0; "
                   "free; free | right : 0; free; free | front : free; 0; free "
                   "| back : free; 0; free | top : free; free; -1e-6",
                   "Boundary conditions/Traction=",
                   "Boundary conditions/Gravity=0; 0; -9.81", "Friction/Law=frictionless",
                   "Contact solver/Method=newton", "Contact solver/Tolerance=1e-11"});
    out() << "weight: certified " << yes(run.converged) << ", nothing to find "
          << yes(is_nothing(estimate(run), energy_norm(run))) << std::endl;
  }

  // Singular edges, stick and slip: the error is where few cells are.
  void sample()
  {
    const Run run(shipped("methods/newton_multigrid.prm"),
                  {"Geometry/Global refinement=4",
                   "Performance/Measure one elastic solve=false",
                   "Output/Write solution=false"});
    const ContactProblem &problem = *run.problem;
    const double all              = estimate(run);
    for (const unsigned int all_up_to : {49152, 16384, 8192})
      {
        const MeshError error = estimate_mesh_error(
          problem.elasticity(), problem.contact_surface(), problem.state(), all_up_to);
        const double eta = std::sqrt(error.square);
        out() << "sample: " << error.n_cells << " cells"
              << (error.is_sampled ? " of 49152" : "") << ", as all say "
              << yes(std::abs(eta / all - 1.) < (error.is_sampled ? 0.05 : 1e-12))
              << std::endl;
      }
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const auto &ending : {std::make_pair("stick", 3e-5), std::make_pair("slip", 2e-4)})
    {
      patch(ending.first, ending.second, {});
      patch(ending.first, ending.second,
            {"Geometry/Contact refinement=2",
             "Geometry/Contact refinement where=x < 0.6 && y > 0.4"});
      patch(ending.first, ending.second,
            {"Geometry/Contact refinement=1", "Geometry/Contact refinement where=x < 0.6",
             "Material/Volume strain=cell mean"});
    }
  bending();
  weight();
  sample();
}
