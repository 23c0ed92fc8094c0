// obstacle.vtu: for each kind of obstacle there are faces, and their vertices
// lie on the surface where it is in the end: moved, with its gap; it is there
// from one end of the body to the other.

#include "tests.h"

#include <cmath>
#include <fstream>
#include <functional>

using namespace stiction;
using dealii::Point;

namespace
{
  // The numbers of the first array after a mark, as many as there are.
  std::vector<double> numbers_after(const std::string &text, const std::string &mark)
  {
    const std::size_t at = text.find(mark);
    std::istringstream in(text.substr(text.find('>', at) + 1));
    std::vector<double> numbers;
    for (double number; in >> number;)
      numbers.push_back(number);
    return numbers;
  }

  struct Kind
  {
    std::string name, obstacle, gap;
    std::function<double(const Point<3> &)> distance; // where it is said to be
  };
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto axis_distance = [](const Point<3> &p, const double height) {
    return std::hypot(p[1] - 1.5, p[2] - height);
  };
  const Point<3> low(2., 1.5, -10.), high(2., 1.5, 12.);
  const double stamp = -0.05;
  {
    // a square below the body, from two triangles
    std::ofstream stl("stamp.stl");
    stl << "solid s\n";
    for (const std::string corners :
         {"0 0 -0.05;4 0 -0.05;4 3 -0.05", "0 0 -0.05;4 3 -0.05;0 3 -0.05"})
      {
        stl << "facet normal 0 0 1\nouter loop\n";
        std::istringstream points(corners);
        for (std::string p; std::getline(points, p, ';');)
          stl << "vertex " << p << '\n';
        stl << "endloop\nendfacet\n";
      }
    stl << "endsolid s\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);

  const std::vector<Kind> kinds = {
    {"foundation", "foundation", "0.01*x",
     [](const auto &p) { return p[2] + 0.01 * p[0]; }},
    {"plane", "plane : 0;0;-0.01;0.01;0;1", "0",
     [](const auto &p) { return (0.01 * p[0] + p[2] + 0.01) / std::hypot(0.01, 1.); }},
    {"sphere", "sphere : 2;1.5;-10;10", "0.01",
     [&](const auto &p) { return p.distance(low) - 10. + 0.01; }},
    {"cavity", "sphere : 2;1.5;12;-12.5", "0",
     [&](const auto &p) { return 12.5 - p.distance(high); }},
    {"cylinder", "cylinder : 0;1.5;-5;1;0;0;5", "0",
     [&](const auto &p) { return axis_distance(p, -5.) - 5.; }},
    {"paraboloid", "paraboloid : 2;1.5;0;0;0;1;5", "0",
     [](const auto &p) {
       return p[2] + (std::pow(p[0] - 2., 2) + std::pow(p[1] - 1.5, 2)) / 10.;
     }},
    {"formula", "formula : z + 0.01*sin(x)", "0",
     [](const auto &p) { return p[2] + 0.01 * std::sin(p[0]); }},
    // no value far from the body, which is left out
    {"formula with an end", "formula : z + 0.001*sqrt(x+0.5)", "0",
     [](const auto &p) { return p[2] + 0.001 * std::sqrt(p[0] + 0.5); }},
    // both halves lie on planes of the cubes that look for them
    {"step", "formula : z + if(x < 2.02, 0, 0.2)", "0",
     [](const auto &p) {
       return std::abs(p[0] - 2.02) < 0.3 ? 0. : p[2] + (p[0] < 2.02 ? 0. : 0.2);
     }},
    {"triangles", "file : stamp.stl", "0.02",
     [&](const auto &p) { return p[2] - stamp + 0.02; }}};
  for (const Kind &kind : kinds)
    {
      const bool stays     = kind.name == "step";
      const double moved[] = {stays ? 0. : 1e-3, stays ? 0. : 2e-3, stays ? 0. : 3e-3};
      const Run run(
        shipped("brick.prm"),
        {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
         "Geometry/Subdivisions=8,6,2", "Geometry/Global refinement=0",
         "Boundary conditions/Prescribed displacement=top : 0; 0; 0",
         "Boundary conditions/Traction=", "Boundary conditions/Pressure=right : 1e6",
         "Boundary conditions/Contact boundary=bottom",
         "Boundary conditions/Obstacle=" + kind.obstacle,
         "Boundary conditions/Initial gap=" + kind.gap,
         std::string("Boundary conditions/Obstacle displacement=") +
           (stays ? "0; 0; 0" : "1e-3; 2e-3; 3e-3"),
         "Friction/Law=coulomb", "Friction/Coefficient=0.3",
         "Contact solver/Method=newton", "Output/Write solution=false"});
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        continue;
      std::ifstream file("results/obstacle.vtu");
      std::stringstream content;
      content << file.rdbuf();
      const std::string text = content.str();
      const auto points      = numbers_after(text, "<DataArray type=\"Float64\"");
      const auto boundaries  = numbers_after(text, "Name=\"boundary\"");
      const auto types       = numbers_after(text, "Name=\"types\"");
      double error = 0., least = 1e30, most = -1e30; // of x
      for (std::size_t i = 0; i < points.size(); i += 3)
        least = std::min(least, points[i]), most = std::max(most, points[i]);
      for (std::size_t i = 0; i < points.size(); i += 3)
        error = std::max(error, std::abs(kind.distance(
                                  Point<3>(points[i] - moved[0], points[i + 1] - moved[1],
                                           points[i + 2] - moved[2]))));
      bool is_bottom = true;
      for (const double boundary : boundaries)
        is_bottom = is_bottom && boundary == 4.;
      out() << kind.name << ": faces "
            << (boundaries.size() > 1 && types.size() == boundaries.size() &&
                    3 * types.size() <= points.size()
                  ? "yes"
                  : "NO")
            << ", of the boundary " << yes(is_bottom) << ", on the surface "
            << yes(error < 1e-7) << ", all along the body "
            << yes(least < 0.05 && most > 3.95) << std::endl;
    }
}
