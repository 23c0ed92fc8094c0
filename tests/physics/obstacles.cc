// Contact with obstacles and on several boundaries, against exact answers: the
// patch test with its foundation given in other ways, a prescribed interference
// (uniaxial strain), a body squeezed between two planes, different laws on
// different boundaries, Hertz.

#include "tests.h"

#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>
#include <fstream>

using namespace stiction;

namespace
{
  constexpr double E = 2e11, nu = 0.3, epsilon = 1e-4, mu = 0.25;
  constexpr double lame = E * nu / ((1. + nu) * (1. - 2. * nu));
  constexpr double G    = E / (2. * (1. + nu));
  constexpr double p    = (lame + 2. * G) * epsilon;

  std::vector<std::string> block(const std::string &method)
  {
    return {"Geometry/Table 1 level=0",
            "Geometry/Lengths=1.5,1.2,1",
            "Geometry/Subdivisions=3,2,2",
            "Geometry/Global refinement=1",
            "Material/Young's modulus=" + exact(E),
            "Material/Poisson ratio=" + exact(nu),
            "Boundary conditions/Traction=",
            "Friction/Coefficient=" + exact(mu),
            "Contact solver/Method=" + method,
            "Contact solver/Tolerance=1e-11"};
  }

  std::vector<std::string> with(std::vector<std::string> settings,
                                const std::vector<std::string> &more)
  {
    settings.insert(settings.end(), more.begin(), more.end());
    return settings;
  }

  // A square of two triangles in the plane z = 0, far larger than the body.
  std::string two_triangles()
  {
    const std::string file =
      "plane." +
      std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) + ".stl";
    std::ofstream stl(file);
    stl << "solid plane\n";
    for (const std::string second : {"9 -9 0\nvertex 9 9 0", "9 9 0\nvertex -9 9 0"})
      stl << "facet normal 0 0 1\nouter loop\nvertex -9 -9 0\nvertex " << second
          << "\nendloop\nendfacet\n";
    stl << "endsolid plane\n";
    return file;
  }

  // The brick on z = 0, pressed and sheared at its top until it slips.
  void patch(const std::string &method, const std::string &obstacle)
  {
    const double shift = 2e-4, angle = dealii::numbers::PI / 6.;
    const double gamma = mu * p / G, s = shift - gamma;
    const double cx = std::cos(angle), cy = std::sin(angle);
    const double sxx = -lame * epsilon;
    const double sxz = G * gamma * cx, syz = G * gamma * cy;
    const Run run(
      shipped("brick.prm"),
      with(block(method), {"Boundary conditions/Obstacle=" + obstacle,
                           "Boundary conditions/Prescribed displacement=top : " +
                             three(shift * cx, shift * cy, -epsilon),
                           "Boundary conditions/Traction=0 : " + three(-sxx, 0, -sxz) +
                             " | 1 : " + three(sxx, 0, sxz) + " | 2 : " +
                             three(0, -sxx, -syz) + " | 3 : " + three(0, sxx, syz)}));

    double error  = 0.;
    const auto &u = run.problem->state().u;
    for (const auto &node : run.problem->elasticity().body().locally_owned_nodes())
      {
        const double z         = node.position[2];
        const double exact_u[] = {cx * (gamma * z + s), cy * (gamma * z + s),
                                  -epsilon * z};
        for (unsigned int c = 0; c < 3; ++c)
          error = std::max(error, std::abs(u(node.dofs[c]) - exact_u[c]) / shift);
      }
    error = dealii::Utilities::MPI::max(error, MPI_COMM_WORLD);

    const auto &surface  = run.problem->contact_surface();
    const auto &lambda   = run.problem->state().lambda;
    const Eigen::Index m = surface.n_nodes();
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const double force     = p * surface.nodes()[i].area;
        const double exact_l[] = {force, mu * force * cx, mu * force * cy};
        for (unsigned int c = 0; c < 3; ++c)
          error = std::max(error, std::abs(lambda(i + c * m) - exact_l[c]) / force);
      }
    out() << method << ", " << obstacle.substr(0, obstacle.find(":")) << ": certified "
          << yes(run.converged) << ", exact to 1e-8 " << yes(error < 1e-8) << std::endl;
  }

  // Held at its top, with a plane in the way that reaches epsilon into it.
  void interference(const std::string &method)
  {
    const double sxx = -lame * epsilon;
    const Run run(shipped("brick.prm"),
                  with(block(method),
                       {"Friction/Law=frictionless",
                        "Boundary conditions/Obstacle=plane : 0; 0; 3*" + exact(epsilon) +
                          "; 0; 0; 1",
                        "Boundary conditions/Initial gap=2*" + exact(epsilon),
                        "Boundary conditions/Prescribed displacement=top : 0; 0; 0",
                        "Boundary conditions/Traction=0 : " + three(-sxx, 0, 0) +
                          " | 1 : " + three(sxx, 0, 0) + " | 2 : " + three(0, -sxx, 0) +
                          " | 3 : " + three(0, sxx, 0)}));
    double error        = 0.;
    const auto &surface = run.problem->contact_surface();
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      error = std::max(
        error,
        std::abs(run.problem->state().lambda(i) / (p * surface.nodes()[i].area) - 1.));
    out() << method << ", interference: certified " << yes(run.converged)
          << ", pressure exact to 1e-8 " << yes(error < 1e-8) << std::endl;
  }

  // Held at its left, squeezed between the foundation and a plane above.
  void squeezed(const std::string &method)
  {
    const Run run(
      shipped("brick.prm"),
      with(block(method),
           {"Boundary conditions/Prescribed displacement=left : 0; 0; 0",
            "Boundary conditions/Contact boundary=bottom | top",
            "Boundary conditions/Obstacle=foundation | plane : 0; 0; 1 - 1e-4; "
            "0; 0; -1",
            "Boundary conditions/Initial gap=-1e-4 | 0"}));
    const auto &surface         = run.problem->contact_surface();
    const auto &lambda          = run.problem->state().lambda;
    const Eigen::Index m        = surface.n_nodes();
    const Eigen::VectorXd force = surface.B().force_to_cartesian(lambda);
    double error = 0., largest = 0.;
    unsigned int pairs = 0;
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < m; ++j)
        {
          auto mirrored = surface.nodes()[j].position;
          mirrored[2]   = 1. - mirrored[2];
          if (surface.nodes()[i].position.distance(mirrored) > 1e-9)
            continue;
          ++pairs;
          largest = std::max(largest, lambda(i));
          error   = std::max({error, std::abs(force(i) - force(j)),
                              std::abs(force(i + m) - force(j + m)),
                              std::abs(force(i + 2 * m) + force(j + 2 * m))});
        }
    const auto &contact = run.summary()["contact"];
    const auto &parts   = contact["boundaries"];
    const double N      = contact["normal_force"];
    out() << method << ", squeezed: certified " << yes(run.converged)
          << ", mirrored forces to 1e-8 "
          << yes(pairs == m && error < 1e-8 * largest && largest > 0.) << ", boundaries "
          << parts[0]["name"] << " and " << parts[1]["name"] << " with "
          << parts[0]["nodes"] << " and " << parts[1]["nodes"]
          << " nodes, half the force each "
          << yes(std::abs(parts[0]["normal_force"].get<double>() - 0.5 * N) < 1e-8 * N &&
                 std::abs(parts[0]["force_on_body"][2].get<double>() +
                          parts[1]["force_on_body"][2].get<double>()) < 1e-8 * N)
          << std::endl;
  }

  // The same with a law a boundary. Forces by method, and the bounds kept.
  Eigen::VectorXd mixed(const std::string &method,
                        const std::string &iteration = "direct")
  {
    const double slip_stress = 2e7;
    const Run run(shipped("brick.prm"),
                  with(block(method),
                       {"Boundary conditions/Prescribed displacement=left : 0; 0; 0",
                        "Boundary conditions/Traction=right : 0; 3e6; 0",
                        "Boundary conditions/Contact boundary=bottom | top",
                        "Boundary conditions/Initial gap=-1e-4",
                        "Contact solver/Coulomb iteration=" + iteration,
                        "Contact solver/Tolerance=1e-9", "Friction/Law=coulomb | given",
                        "Friction/Coefficient=" + exact(mu) + " | 77",
                        "Friction/Slip stress=1e99 | " + exact(slip_stress)}));
    const auto &surface  = run.problem->contact_surface();
    const auto &lambda   = run.problem->state().lambda;
    const auto statuses  = run.problem->node_statuses();
    const Eigen::Index m = surface.n_nodes();
    std::array<unsigned int, 2> slipping{};
    double error = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        const double friction   = std::hypot(lambda(i + m), lambda(i + 2 * m));
        const double bound =
          node.boundary == 0 ? mu * lambda(i) : slip_stress * node.area;
        if (statuses[i].tangential != TangentialStatus::slip)
          continue;
        ++slipping[node.boundary];
        error = std::max(error, std::abs(friction - bound) / (p * node.area));
      }
    out() << method << " (" << iteration << "), mixed laws: certified "
          << yes(run.converged) << ", slips on both "
          << yes(slipping[0] > 0 && slipping[1] > 0) << ", at the bounds of both laws "
          << yes(error < 1e-8) << ", law " << run.summary()["solver"]["law"] << std::endl;
    return lambda;
  }

  // A rigid sphere pressed into a block, on a coarse mesh.
  void hertz(const std::string &obstacle)
  {
    const Run run(shipped("brick.prm"),
                  with(block("newton multigrid"),
                       {"Geometry/Lengths=1,1,0.5", "Geometry/Subdivisions=2,2,1",
                        "Geometry/Global refinement=4", "Friction/Law=frictionless",
                        "Contact solver/Tolerance=1e-8",
                        "Boundary conditions/Prescribed displacement=bottom : 0; 0; 0",
                        "Boundary conditions/Contact boundary=top",
                        "Boundary conditions/Obstacle=" + obstacle}));
    const auto &surface = run.problem->contact_surface();
    const auto &lambda  = run.problem->state().lambda;
    double P = 0., second = 0., p0 = 0.;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        const double r = std::hypot(node.position[0] - 0.5, node.position[1] - 0.5);
        P += lambda(i);
        second += lambda(i) * r * r;
        p0 = std::max(p0, lambda(i) / node.area);
      }
    const double R = 1., E_star = E / (1. - nu * nu);
    const double a        = std::cbrt(3. * P * R / (4. * E_star));
    const double right_p0 = 3. * P / (2. * dealii::numbers::PI * a * a);
    out() << obstacle.substr(0, obstacle.find(":")) << ": certified "
          << yes(run.converged) << ", Hertz' pressure within a tenth "
          << yes(std::abs(p0 / right_p0 - 1.) < 0.1) << ", radius within a tenth "
          << yes(std::abs(std::sqrt(2.5 * second / P) / a - 1.) < 0.1) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string method : {"gauss seidel", "newton multigrid"})
    {
      for (const std::string &obstacle :
           {std::string("foundation"), std::string("plane : 3; 4; 0; 0; 0; 2"),
            std::string("formula : z*(2 + x)"), "file : " + two_triangles()})
        patch(method, obstacle);
      interference(method);
      squeezed(method);
    }

  const Eigen::VectorXd first = mixed("gauss seidel");
  double error                = 0.;
  for (const std::string method : {"newton", "mpgp", "admm", "newton multigrid"})
    error = std::max(error, (mixed(method) - first).norm() / first.norm());
  error = std::max(error, (mixed("newton", "fixed point") - first).norm() / first.norm());
  out() << "mixed laws, methods agree to 1e-6: " << yes(error < 1e-6) << std::endl;

  hertz("sphere : 0.5; 0.5; 1.49; 1");
  hertz("paraboloid : 0.5; 0.5; 0.49; 0; 0; -1; 1");
}
