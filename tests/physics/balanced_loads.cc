// Loads that balance one another on bodies that contact alone holds, so that what is left
// of them is rounding, which nothing has to bear: a ring under pressure from outside
// around a rigid shaft, and from inside in a rigid bore, as Lame has it; a block pressed
// from all sides between two plates; a block on a table that is squeezed, by forces of
// any size. A clamped block whose load acts on the contact face, where nothing gives way.

#include "tests.h"

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace stiction;

namespace
{
  std::string write(const std::string &text)
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::ofstream("input.prm") << text;
    MPI_Barrier(MPI_COMM_WORLD);
    return "input.prm";
  }

  std::string problem(const std::string &geometry, const std::string &conditions,
                      const std::string &law)
  {
    return "subsection Geometry\n" + geometry +
           "end\nsubsection Material\nset Young's modulus = 5000\nset Poisson ratio = "
           "0.3\nend\nsubsection Boundary conditions\n" +
           conditions + "end\nsubsection Friction\n" + law +
           "end\nsubsection Contact solver\nset Tolerance = 1e-8\nend\n";
  }

  // The mean pressure over the area, and what is exact.
  void compare(const std::string &name, const std::string &file, const double exact,
               const double tolerance, const std::vector<Method> &methods)
  {
    bool certified = true;
    double worst   = 0.;
    for (const Method &method : methods)
      {
        const Run run(file, method.settings);
        const auto &surface = run.problem->contact_surface();
        const double mean   = run.problem->state().lambda.head(surface.n_nodes()).sum() /
                            surface.areas().sum();
        certified = certified && run.converged;
        worst     = std::max(worst, std::abs(mean - exact) / std::max(exact, 1.));
      }
    out() << name << ": certified " << yes(certified) << ", pressure to "
          << 100. * tolerance << " % " << yes(worst < tolerance) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::vector<Method> methods = all_methods(); // of rings those that certify them
  methods.erase(std::remove_if(methods.begin(), methods.end(),
                               [](const Method &method) {
                                 return method.name == "admm" ||
                                        method.name == "gauss seidel";
                               }),
                methods.end());
  const std::string ring = "set Type = cylinder\nset Inner radius = 10\nset Radius = "
                           "14\nset Length = 1\nset Global refinement = 1\nset Element "
                           "degree = 2\n",
                    flat = "set Prescribed displacement = bottom : free; free; 0 | top : "
                           "free; free; 0\n",
                    smooth = "set Law = frictionless\n",
                    rough  = "set Law = coulomb\nset Coefficient = 0.2\n";
  // plane strain, with no radial displacement at the rigid side
  const double nu = 0.3, a = 10., b = 14., p = 10.;
  const double at_shaft = p * 2. * (1. - nu) * b * b / (a * a * (1. - 2. * nu) + b * b);
  const double at_bore  = p * 2. * (1. - nu) * a * a / (b * b * (1. - 2. * nu) + a * a);
  for (const std::string &law : {smooth, rough})
    {
      const std::string name = law == smooth ? "" : ", with friction";
      compare("ring on a shaft" + name,
              write(problem(ring,
                            flat + "set Pressure = side : 10\nset Contact boundary = "
                                   "inside\nset Obstacle = cylinder : 0;0;0;0;0;1;10\n",
                            law)),
              at_shaft, 0.01, methods);
      compare("ring in a bore" + name,
              write(problem(ring,
                            flat + "set Pressure = inside : 10\nset Contact boundary = "
                                   "side\nset Obstacle = cylinder : 0;0;0;0;0;1;-14\n",
                            law)),
              at_bore, 0.01, methods);
    }
  const std::string cube = "set Lengths = 1, 1, 1\nset Subdivisions = 3, 3, 3\n";
  compare(
    "pressed from four sides between plates",
    write(problem(cube,
                  "set Pressure = left : 10.3 | right : 10.3 | front : 10.3 | back : "
                  "10.3\nset Contact boundary = bottom | top\nset Obstacle = plane : "
                  "0;0;0;0;0;1 | plane : 0;0;1;0;0;-1\n",
                  smooth)),
    2. * 0.3 * 10.3, 1e-7, all_methods());
  for (const std::string size : {"1e-9", "1", "1e9"})
    compare("squeezed by " + size,
            write(problem(cube,
                          "set Pressure = left : 10.3*" + size + " | right : 10.3*" +
                            size + "\nset Contact boundary = bottom\n",
                          rough)),
            0., 1e-6 * std::max(1., std::stod(size)), all_methods());
  compare("clamped, pressed on the contact face itself",
          write(problem(cube,
                        "set Prescribed displacement = top : 0; 0; 0\nset Traction = "
                        "bottom : 0; 0; -10\nset Contact boundary = bottom\n",
                        rough)),
          10., 1e-6, {all_methods().front(), all_methods().end()[-2]});
}
