// A tube that is shrunk onto another one, without friction: exact, the pressure is that
// of Lame, E d/b (c^2 - b^2)(b^2 - a^2)/(2 b^2 (c^2 - a^2)) with radii a, b, c and an
// interference of d, whatever the elements and their size. Where the inner tube is
// longer, and has smaller cells, forces are on the one that ends within it, so that no
// node beyond its edge bears any.

#include <stiction/contact/interface/contact_boundary.h>

#include "several_bodies.h"

using namespace stiction;

namespace
{
  std::string tubes(const std::string &length, const std::string &refinement)
  {
    return file(
      "tubes.prm",
      section("Body inner", {"Type = cylinder", "Inner radius = 10", "Radius = 20",
                             "Length = " + length, "Refinement = 2"}) +
        section("Body outer", {"Type = cylinder", "Inner radius = 20", "Radius = 40",
                               "Length = 20", "Refinement = " + refinement}) +
        section("Material", {"Young's modulus = 210000", "Poisson ratio = 0.3"}) +
        section("Boundary conditions", {"Prescribed displacement = inner.bottom : free; "
                                        "free; 0 | outer.bottom : free; free; 0"}) +
        section("Contact pair fit",
                {"Boundary = outer.inside", "Obstacle = boundary : inner.side",
                 "Mesh gap = removed", "Initial gap = -0.02", "Law = frictionless"}));
  }

  double pressure(const Run &run)
  {
    const auto &surface = run.problem->contact_surface();
    return run.problem->state().lambda.head(surface.n_nodes()).sum() /
           surface.areas().sum();
  }

  constexpr double a = 10., b = 20., c = 40., d = 0.02, E = 210000.;
  constexpr double lame =
    E * d / b * (c * c - b * b) * (b * b - a * a) / (2. * b * b * (c * c - a * a));

  void end_within(const std::string &length)
  {
    const Run run(tubes(length, "2"), {});
    const auto &surface = run.problem->contact_surface();
    const auto &lambda  = run.problem->state().lambda;
    out() << "outer tube on one of " << length << ": certified " << yes(run.converged)
          << ", forces on the side " << surface.boundaries()[0].name()
          << ", largest pressure below that of Lame twice "
          << yes((lambda.head(surface.n_nodes()).array() / surface.areas().array())
                   .maxCoeff() < 2. * lame)
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string degree : {"1", "2"})
    for (const std::string method : {"newton multigrid", "newton"})
      {
        const Run run(tubes("20", "1"), {"Geometry/Element degree=" + degree,
                                         "Contact solver/Method=" + method});
        out() << "degree " << degree << ", " << method << ": certified "
              << yes(run.converged) << ", pressure of Lame to "
              << (degree == "1" ? "2 % " : "0.1 % ")
              << yes(std::abs(pressure(run) / lame - 1.) < (degree == "1" ? 0.02 : 0.001))
              << std::endl;
      }
  for (const std::string length : {"60", "21.5"})
    end_within(length);
}
