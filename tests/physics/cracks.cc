// Cracks: both sides of a pair are boundaries of one body and share the nodes of the tip,
// which the mesh holds together. Exact: under pressure a body with a slit is as one
// without, with the pressure at all nodes of the slit; pulled it opens and bears nothing.
// Lips that are sheared rub by what is known of an infinite plate.
// Obstacles of triangles with an edge that touches a node: a wedge that is symmetric
// presses straight, however its triangles stand in the file.

#include <stiction/base/errors.h>

#include "several_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

using namespace stiction;

namespace
{
  const Settings exactly{"Contact solver/Tolerance=1e-11"};

  // Of unit cubes, 4 x 2 x 4, with a slit where z = 2 and x < 2, in Abaqus' format.
  std::string slit()
  {
    constexpr unsigned int n = 4, depth = 2, layer = 5 * 3;
    std::ostringstream nodes, elements;
    const auto node = [](const unsigned int i, const unsigned int j, const unsigned int k,
                         const bool is_above) {
      const bool is_second = k == 2 && i < 2 && is_above;
      return 1 + i + 5 * j + layer * k + (is_second ? 1000 : 0);
    };
    for (unsigned int k = 0; k <= n; ++k)
      for (unsigned int j = 0; j <= depth; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          for (const bool is_above : {false, true})
            if (!is_above || node(i, j, k, true) > 1000)
              nodes << node(i, j, k, is_above) << ", " << i << ", " << j << ", " << k
                    << '\n';
    std::array<std::string, 4> faces;
    unsigned int number = 0;
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int j = 0; j < depth; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            elements << ++number;
            for (const unsigned int up : {0, 1})
              for (const auto &[x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
                elements << ", " << node(i + x, j + y, k + up, k >= 2);
            elements << '\n';
            const auto add = [&](const unsigned int surface, const char *const face) {
              faces[surface] += std::to_string(number) + ", " + face + '\n';
            };
            if (k == 0)
              add(0, "S1");
            if (k == n - 1)
              add(1, "S2");
            if (i < 2 && k == 1)
              add(2, "S2");
            if (i < 2 && k == 2)
              add(3, "S1");
          }
    return "*NODE\n" + nodes.str() + "*ELEMENT, TYPE=C3D8, ELSET=all\n" + elements.str() +
           "*SURFACE, NAME=bottom\n" + faces[0] + "*SURFACE, NAME=top\n" + faces[1] +
           "*SURFACE, NAME=lower\n" + faces[2] + "*SURFACE, NAME=upper\n" + faces[3];
  }

  // Of pressures from the one that is applied, of which a pull is negative; of open lips
  // the pressures.
  double error_of_pressures(const double pressure, const Settings &settings)
  {
    const Run run(
      file("slit.prm",
           section("Geometry", {"Mesh file = " + file("slit.inp", slit())}) +
             section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
             section("Boundary conditions",
                     {"Prescribed displacement = bottom : free; free; 0",
                      "Prescribed points = 4;0;0 : 0;0;free | 4;2;0 : 0;free;free",
                      "Pressure = top : " + std::to_string(pressure)}) +
             section("Contact pair crack",
                     {"Boundary = lower", "Obstacle = boundary : upper", "Law = coulomb",
                      "Coefficient = 0.3"})),
      settings + exactly);
    double error        = run.converged ? 0. : 1.;
    const auto &surface = run.problem->contact_surface();
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      error =
        std::max(error, std::abs(run.problem->state().lambda(i) / surface.areas()(i) -
                                 std::max(pressure, 0.)));
    return error;
  }

  // The slip of the shipped crack in its middle, over that in an infinite plate.
  double slip_of_lips()
  {
    const Run run(shipped("crack.prm"), {"Output/Directory=crack"});
    const auto &surface        = run.problem->contact_surface();
    const Eigen::Index m       = surface.n_nodes();
    const Eigen::VectorXd slip = surface.gap_and_slip(run.problem->state()).tail(2 * m);
    const double in_the_infinite =
      4. * (1. - 0.3 * 0.3) / 210000. * 2. * (60. - 0.4 * 100.);
    return slip.lpNorm<Eigen::Infinity>() / in_the_infinite;
  }

  // The forces across and along the axis of a wedge whose ridge is along x, of slope 1/2,
  // with its point down, that is pressed onto a block.
  std::array<double, 2> wedge(const bool is_turned_around)
  {
    std::vector<std::string> triangles{"-1 1 2  2 5 4  2 1 2", "-1 1 2  -1 5 4  2 5 4",
                                       "2 1 2  -1 -3 4  -1 1 2",
                                       "2 1 2  2 -3 4  -1 -3 4"};
    if (is_turned_around)
      std::reverse(triangles.begin(), triangles.end());
    std::string stl = "solid wedge\n";
    for (const std::string &corners : triangles)
      {
        std::istringstream numbers(corners);
        stl += "facet normal 0 0 0\nouter loop\n";
        for (std::string x, y, z; numbers >> x >> y >> z;)
          stl += "vertex " + x + ' ' + y + ' ' + z + '\n';
        stl += "endloop\nendfacet\n";
      }
    const Run run(
      file(
        "wedge.prm",
        section("Geometry", {"Lengths = 1,2,2", "Subdivisions = 2,8,8"}) +
          section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
          section("Boundary conditions", {"Prescribed displacement = bottom : 0; 0; 0"}) +
          section("Contact pair c",
                  {"Boundary = top",
                   "Obstacle = file : " + file("wedge.stl", stl + "endsolid wedge\n"),
                   "Displacement = 0; 0; -0.05", "Law = frictionless"})),
      exactly);
    const auto force = run.summary()["contact"]["force_on_body"];
    return {{force[1], force[2]}};
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string method : {"newton", "newton multigrid", "mpgp"})
    for (const std::string mesh :
         {"Geometry/Element degree=1", "Geometry/Element degree=2",
          "Geometry/Global refinement=1"})
      {
        const Settings settings{"Contact solver/Method=" + method, mesh};
        out() << method << ", " << mesh << ": pressed "
              << yes(error_of_pressures(1., settings) < 1e-8) << ", pulled "
              << yes(error_of_pressures(-1., settings) < 1e-8) << std::endl;
      }
  out() << "a crack in a plate slips as in an infinite one, to 4 %: "
        << yes(std::abs(slip_of_lips() - 1.) < 0.04) << std::endl;
  const auto first = wedge(false), second = wedge(true);
  out() << "a wedge presses straight: "
        << yes(std::abs(first[0]) < 1e-8 && first[1] < -1.)
        << ", however its triangles stand: "
        << yes(std::abs(first[0] - second[0]) + std::abs(first[1] - second[1]) < 1e-8)
        << std::endl;
}
