// Patch tests on meshes other than the brick's. First the distorted block from
// files of every format, pressed onto the foundation and sheared: the exact
// solution is linear in space, so that trilinear elements reproduce it on any
// mesh. Then bodies with curved boundaries, compressed without friction.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>
#include <functional>

using namespace stiction;

namespace
{
  constexpr double E = 2e11, nu = 0.3, epsilon = 1e-4;
  const double lame     = E * nu / ((1. + nu) * (1. - 2. * nu));
  const double G        = E / (2. * (1. + nu));
  const double pressure = (lame + 2. * G) * epsilon;

  using Vector = dealii::Tensor<1, 3>;

  std::vector<std::string> material_and_method(const std::string &method)
  {
    return {"Material/Young's modulus=" + exact(E), "Material/Poisson ratio=" + exact(nu),
            "Contact solver/Method=" + method, "Contact solver/Tolerance=1e-11",
            "Geometry/Table 1 level=0"};
  }

  // Prints whether the displacement is u(x) and the traction on the foundation
  // the given one, relative to the sizes of both.
  void compare(const std::string &title, const Run &run,
               const std::function<Vector(const dealii::Point<3> &)> &exact_u,
               const Vector &traction, const double size)
  {
    const Body &body = run.problem->elasticity().body();
    const auto &u    = run.problem->state().u;
    double error_u   = 0.;
    for (const auto &node : body.locally_owned_nodes())
      for (unsigned int c = 0; c < 3; ++c)
        error_u =
          std::max(error_u, std::abs(u(node.dofs[c]) - exact_u(node.position)[c]) / size);
    error_u = dealii::Utilities::MPI::max(error_u, MPI_COMM_WORLD);

    const auto &surface  = run.problem->contact_surface();
    const auto &lambda   = run.problem->state().lambda;
    const Eigen::Index m = surface.n_nodes();
    double error_lambda  = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const auto &node   = surface.nodes()[i];
        const Vector force = lambda(i) * node.normal + lambda(i + m) * node.tangent1 +
                             lambda(i + 2 * m) * node.tangent2 - node.area * traction;
        error_lambda =
          std::max(error_lambda, force.norm() / (node.area * traction.norm()));
      }
    out() << title << ": certified " << yes(run.converged)
          << ", displacement exact to 1e-8 " << yes(error_u < 1e-8)
          << ", contact forces exact to 1e-8 " << yes(m > 0 && error_lambda < 1e-8)
          << ", contact area " << surface.boundary_area() << std::endl;
  }

  // Boundaries in the order left, right, front, back, bottom, top.
  void block(const std::string &file, const std::vector<std::string> &names,
             const std::string &method, const double shift)
  {
    const double mu    = 0.25;
    const bool sticks  = G * shift <= mu * pressure;
    const double gamma = sticks ? shift : mu * pressure / G;
    const double s     = shift - gamma;
    const double angle = 30. / 180. * dealii::numbers::PI;
    const double cx = std::cos(angle), cy = std::sin(angle);
    const double sxx = -lame * epsilon;
    const double sxz = G * gamma * cx, syz = G * gamma * cy;
    auto settings = material_and_method(method);
    for (const char *const setting :
         {"Geometry/Type=file", "Geometry/Global refinement=1", "Friction/Law=coulomb"})
      settings.push_back(setting);
    settings.push_back("Geometry/Mesh file=" + shipped("meshes/" + file));
    settings.push_back("Friction/Coefficient=" + exact(mu));
    settings.push_back("Boundary conditions/Prescribed displacement=" + names[5] + " : " +
                       three(shift * cx, shift * cy, -epsilon));
    settings.push_back(
      "Boundary conditions/Traction=" + names[0] + " : " + three(-sxx, 0, -sxz) + " | " +
      names[1] + " : " + three(sxx, 0, sxz) + " | " + names[2] + " : " +
      three(0, -sxx, -syz) + " | " + names[3] + " : " + three(0, sxx, syz));
    settings.push_back("Boundary conditions/Contact boundary=" + names[4]);
    const Run run(shipped("brick.prm"), settings);

    unsigned int right_status = 0;
    const Eigen::Index m      = run.problem->contact_surface().n_nodes();
    const auto statuses       = run.problem->node_statuses();
    for (Eigen::Index i = 0; i < m; ++i)
      if (statuses[i].normal == NormalStatus::closed &&
          statuses[i].tangential ==
            (sticks ? TangentialStatus::stick : TangentialStatus::slip))
        ++right_status;
    compare(
      file + ", " + method + ", all nodes " + (sticks ? "stick " : "slip ") +
        yes(right_status == m),
      run,
      [&](const dealii::Point<3> &x) {
        return Vector(
          {cx * (gamma * x[2] + s), cy * (gamma * x[2] + s), -epsilon * x[2]});
      },
      Vector({G * gamma * cx, G * gamma * cy, -pressure}), shift);
  }

  // Compressed by ε along z between a foundation on the contact boundary at z =
  // level and the boundary that is moved; sides are free and become wider.
  void column(const std::string &title, const std::vector<std::string> &geometry,
              const std::string &contact, const std::string &moved, const double level)
  {
    auto settings = material_and_method("newton multigrid");
    settings.insert(settings.end(), geometry.begin(), geometry.end());
    const std::string wider = exact(nu * epsilon);
    settings.push_back("Friction/Law=frictionless");
    settings.push_back("Boundary conditions/Traction=");
    settings.push_back("Boundary conditions/Contact boundary=" + contact);
    settings.push_back("Boundary conditions/Prescribed displacement=" + moved + " : " +
                       wider + "*x; " + wider + "*y; " + exact(-epsilon) + "*(z-" +
                       exact(level) + ")");
    const Run run(shipped("brick.prm"), settings);
    const auto corners =
      run.problem->elasticity().body().bounding_box().get_boundary_points();
    const double sign = run.problem->contact_surface().nodes()[0].normal[2];
    out() << "lengths " << corners.second - corners.first << "; ";
    compare(
      title, run,
      [&](const dealii::Point<3> &x) {
        return Vector(
          {nu * epsilon * x[0], nu * epsilon * x[1], -epsilon * (x[2] - level)});
      },
      Vector({0., 0., sign * E * epsilon}), epsilon);
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::vector<std::string> names = {"left", "right",  "front",
                                          "back", "bottom", "top"};
  for (const std::string method : {"newton", "newton multigrid"})
    for (const double shift : {3e-5, 2e-4})
      {
        block("distorted_block.msh", names, method, shift);
        block("distorted_block_22.msh", names, method, shift);
        block("distorted_block.inp", names, method, shift);
        block("distorted_block.vtk", {"11", "12", "13", "14", "15", "16"}, method, shift);
      }

  column("cylinder, refined twice",
         {"Geometry/Type=cylinder", "Geometry/Radius=0.5", "Geometry/Length=1.5",
          "Geometry/Global refinement=2"},
         "bottom", "top", 0.);
  column("cylinder of curved cells",
         {"Geometry/Type=cylinder", "Geometry/Radius=0.5", "Geometry/Length=1.5",
          "Geometry/Element degree=2", "Geometry/Global refinement=1"},
         "bottom", "top", 0.);
  column(
    "half ball on its flat face, refined once",
    {"Geometry/Type=half ball", "Geometry/Radius=0.5", "Geometry/Global refinement=1"},
    "flat", "curved", 0.5);
  column("hyper_cube by deal.II's generator, refined twice",
         {"Geometry/Type=generator", "Geometry/Generator=hyper_cube",
          "Geometry/Generator arguments=-1 : 1 : true", "Geometry/Global refinement=2"},
         "4", "5", -1.);
}
