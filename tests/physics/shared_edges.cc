// Nodes of several contact boundaries, which bear the forces of the first of them: those
// beside them bear what the others exert there. Exact: a block in a box, turned, without
// friction, bears one pressure on the floor and ν/(1 - ν) of it on each wall, also where
// three walls meet; a block between a floor and a wall that are bodies themselves, on
// other meshes, one pressure on each; where the first boundary of an edge has nothing
// opposite the second one has all of its nodes. And a block that slides into a corner
// with friction: all forces and moments that are written balance the loads.

#include <deal.II/base/numbers.h>

#include "several_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace stiction;

namespace
{
  const Settings exactly{"Contact solver/Tolerance=1e-11"};

  // How far the pressure of the nodes of each boundary is from the expected one,
  // relative; 1 where there is no such node.
  double error_of_pressures(const Run &run, const std::vector<double> &expected)
  {
    const auto &surface  = run.problem->contact_surface();
    const auto &lambda   = run.problem->state().lambda;
    const Eigen::Index m = surface.n_nodes();
    std::vector<double> errors(expected.size(), -1.);
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const unsigned int b = surface.nodes()[i].boundary;
        const Eigen::Vector3d at(lambda(i) / surface.areas()(i) - expected[b],
                                 lambda(i + m), lambda(i + 2 * m));
        errors[b] = std::max(errors[b], at.norm() / expected.front());
      }
    return std::count(errors.begin(), errors.end(), -1.) > 0
             ? 1.
             : *std::max_element(errors.begin(), errors.end());
  }

  // In a box of 3 x 2 x 2, turned by 30 degrees about the edge at the origin.
  double box(const Settings &settings)
  {
    const double c = std::cos(dealii::numbers::PI / 6.), s = 0.5;
    const auto wall = [&](const std::string &name, const double x, const double y,
                          const std::array<double, 3> &n) {
      return section("Contact pair " + name,
                     {"Boundary = " + name,
                      "Obstacle = plane : " + three(c * x - s * y, s * x + c * y, 0.) +
                        ";" + three(c * n[0] - s * n[1], s * n[0] + c * n[1], n[2]),
                      "Law = frictionless"});
    };
    const Run run(
      file("box.prm",
           section("Body block", {"Lengths = 3,2,2", "Subdivisions = 4,3,3",
                                  "Rotation = 0;0;0;0;0;1;30", "Young's modulus = 1000",
                                  "Poisson ratio = 0.4"}) +
             section("Boundary conditions", {"Pressure = block.top : 1"}) +
             wall("block.bottom", 0., 0., {{0., 0., 1.}}) +
             wall("block.left", 0., 0., {{1., 0., 0.}}) +
             wall("block.right", 3., 0., {{-1., 0., 0.}}) +
             wall("block.front", 0., 0., {{0., 1., 0.}}) +
             wall("block.back", 0., 2., {{0., -1., 0.}})),
      settings + exactly);
    const double beside = 0.4 / 0.6;
    return run.converged ? error_of_pressures(run, {1., beside, beside, beside, beside})
                         : 1.;
  }

  // Pressed onto the floor and against the wall.
  double between_bodies(const std::string &slave, const Settings &settings)
  {
    const Run run(
      file("bodies.prm",
           brick("floor", "3,2,1", "5,4,2", "0;0;-1") +
             brick("wall", "1,2,2", "2,5,3", "-1;0;0", "0;0;0;0;0;1;0", "300") +
             brick("block", "3,2,2", "4,3,4", "0;0;0") +
             section("Boundary conditions",
                     {"Prescribed displacement = floor.bottom : free; free; 0 | "
                      "floor.left : 0; free; free | floor.front : free; 0; free | "
                      "wall.left : 0; free; free | wall.bottom : free; free; 0 | "
                      "wall.front : free; 0; free | block.front : free; 0; free",
                      "Pressure = block.top : 1 | block.right : 0.5"}) +
             section("Contact pair below",
                     {"Boundary = block.bottom", "Obstacle = boundary : floor.top",
                      "Law = frictionless", "Slave side = " + slave}) +
             section("Contact pair beside",
                     {"Boundary = block.left", "Obstacle = boundary : wall.right",
                      "Law = frictionless", "Slave side = boundary"})),
      settings + exactly);
    return run.converged ? error_of_pressures(run, {1., 0.5}) : 1.;
  }

  // The floor begins beyond the edge. @return how many nodes of the wall bear 0.5.
  unsigned int beyond_the_floor(const Settings &settings)
  {
    const Run run(
      file("beyond.prm",
           brick("floor", "2,2,1", "2,2,1", "1.5;0;-1") +
             brick("block", "3,2,2", "6,3,3", "0;0;0") +
             section("Boundary conditions",
                     {"Prescribed displacement = floor.bottom : 0; 0; 0 | "
                      "block.front : free; 0; free | block.bottom : free; free; 0",
                      "Pressure = block.right : 0.5"}) +
             section("Contact pair below",
                     {"Boundary = block.bottom", "Obstacle = boundary : floor.top",
                      "Law = frictionless", "Slave side = obstacle"}) +
             section("Contact pair beside",
                     {"Boundary = block.left", "Obstacle = plane : 0;0;0; 1;0;0",
                      "Law = frictionless"})),
      settings + exactly);
    const auto &surface = run.problem->contact_surface();
    unsigned int n      = 0;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      if (surface.nodes()[i].boundary == 1 &&
          std::abs(run.problem->state().lambda(i) / surface.areas()(i) / 0.5 - 1.) < 1e-9)
        ++n;
    return n;
  }

  // The forces and moments that the summary says, and the loads, relative to these.
  double imbalance(const Settings &settings)
  {
    const Run run(
      file("corner.prm",
           brick("block", "3,2,2", "6,4,4", "0;0;0") +
             section("Boundary conditions",
                     {"Traction = block.right : -1; 0.1*y; 0 | block.top : 0; 0; -1"}) +
             section("Contact pair below",
                     {"Boundary = block.bottom", "Obstacle = plane : 0;0;0; 0;0;1",
                      "Law = coulomb", "Coefficient = 0.3"}) +
             section("Contact pair beside",
                     {"Boundary = block.left", "Obstacle = plane : 0;0;0; 1;0;0",
                      "Law = coulomb", "Coefficient = 0.2"})),
      settings + exactly);
    const auto contact = run.summary()["contact"];
    const dealii::Tensor<1, 3> loads({-4., 0.4, -6.}), moments = moment_of_loads(run);
    double error = run.converged ? 0. : 1.;
    for (unsigned int c = 0; c < 3; ++c)
      error =
        std::max({error, std::abs(contact["force_on_body"][c].get<double>() + loads[c]),
                  std::abs(contact["moment"][c].get<double>() + moments[c])});
    return error / moments.norm();
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Method &method : all_methods())
    {
      out() << method.name << ": in a box " << yes(box(method.settings) < 1e-8)
            << ", in balance " << yes(imbalance(method.settings) < 1e-8);
      if (method.name != "newton multigrid, amg") // it takes no pairs
        out() << ", between bodies "
              << yes(between_bodies("boundary", method.settings) < 1e-8 &&
                     between_bodies("obstacle", method.settings) < 1e-8);
      out() << std::endl;
    }
  out() << "second order, in a box " << yes(box({"Geometry/Element degree=2"}) < 1e-8)
        << std::endl
        << "no floor at the edge: nodes of the wall " << beyond_the_floor({})
        << std::endl;
}
