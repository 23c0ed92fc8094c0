// Contact boundaries that go around sharp edges, such as the whole surface of a block in
// one group, and round bodies. Exact: a block in a box, under its weight, has one
// pressure below and none beside; on a plate it slides at F times its weight, and at once
// without friction. A round body touches a flat one where it is, wherever mesh lines of
// the flat one are; two balls bear what one bears on the plane between them, but for the
// error of the mesh. And a body that stands on an edge is named.

#include <stiction/base/errors.h>

#include "several_bodies.h"

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  const Settings exactly{"Contact solver/Tolerance=1e-11"};

  // All of its boundary has number 0.
  std::string cube(const std::string &name, const std::string &translation)
  {
    return section("Body " + name, {"Type = generator", "Generator = hyper_cube",
                                    "Generator arguments = 0 : 1 : false",
                                    "Refinement = 2", "Translation = " + translation,
                                    "Young's modulus = 1000", "Poisson ratio = 0"});
  }

  // Of pressures at nodes that look down, from 1, and of what other nodes bear.
  double error_of_pressures(const Run &run)
  {
    const auto &surface = run.problem->contact_surface();
    double error        = run.converged ? 0. : 1.;
    double area         = 0.;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const bool is_below = surface.nodes()[i].normal[2] < -0.99;
        area += is_below ? surface.areas()(i) : 0.;
        error =
          std::max(error, std::abs(run.problem->state().lambda(i) / surface.areas()(i) -
                                   (is_below ? 1. : 0.)));
      }
    return std::abs(area - 1.) < 1e-9 ? error : 1.;
  }

  double in_a_box(const Settings &settings)
  {
    const Run run(
      file("box.prm", cube("block", "0;0;0") +
                        section("Boundary conditions", {"Body force = 0; 0; -1"}) +
                        section("Contact pair all around",
                                {"Boundary = block.0", "Obstacle = foundation",
                                 "Law = coulomb", "Coefficient = 0.3"})),
      settings + exactly);
    return error_of_pressures(run);
  }

  std::string on_a_plate(const std::string &push, const std::string &coefficient,
                         const Settings &settings)
  {
    try
      {
        const Run run(
          file("plate.prm",
               brick("plate", "3,3,1", "7,7,2", "-1;-1;-1") + cube("block", "0;0;0") +
                 section("Boundary conditions",
                         {"Prescribed displacement = plate.bottom : 0; 0; 0",
                          "Body force = " + push + "; 0; if(z > 0, -1, 0)"}) +
                 section("Contact pair c",
                         {"Boundary = block.0", "Obstacle = boundary : plate.top",
                          "Slave side = boundary", "Law = coulomb",
                          "Coefficient = " + coefficient})),
          settings);
        const double force = run.summary()["contact"]["normal_force"];
        return run.converged && std::abs(force - 1.) < 1e-5 ? "certified" : "WRONG";
      }
    catch (const InputError &)
      {
        return "refused";
      }
  }

  // The force of half a ball that is pressed onto a plate.
  double ball_on_plate(const double shift, const std::string &cells)
  {
    const Run run(
      file("ball.prm",
           section("Body ball", {"Type = half ball", "Radius = 10", "Refinement = 2",
                                 "Young's modulus = 1e5", "Poisson ratio = 0.3"}) +
             section("Body plate", {"Lengths = 20,20,4", "Subdivisions = " + cells,
                                    "Translation = " + three(-10. + shift, -10., -4.),
                                    "Young's modulus = 1e12", "Poisson ratio = 0"}) +
             section("Boundary conditions",
                     {"Prescribed displacement = ball.flat : 0; 0; -0.02 | "
                      "plate.bottom : 0; 0; 0"}) +
             section("Contact pair c",
                     {"Boundary = ball.curved", "Obstacle = boundary : plate.top",
                      "Law = frictionless", "Slave side = boundary"})),
      exactly);
    return run.summary()["contact"]["normal_force"];
  }

  // Of the curved boundary of half a ball of a few cells.
  unsigned int n_parts_of_ball()
  {
    const Run run(
      file("coarse.prm",
           section("Geometry", {"Type = half ball", "Radius = 1"}) +
             section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
             section("Boundary conditions",
                     {"Prescribed displacement = flat : 0; 0; -0.01"}) +
             section("Contact pair c", {"Boundary = curved", "Obstacle = foundation",
                                        "Law = frictionless"})),
      {});
    unsigned int n = 0;
    for (const auto &node : run.problem->contact_surface().nodes())
      n = std::max(n, node.part + 1);
    return n;
  }

  // Of two whole balls one above the other, or of one above the plane between them.
  double ball(const bool on_another)
  {
    const auto body = [](const std::string &name, const std::string &z) {
      return section("Body " + name,
                     {"Type = generator", "Generator = hyper_ball_balanced",
                      "Generator arguments = 0,0,0 : 1", "Refinement = 2",
                      "Translation = 0; 0; " + z, "Young's modulus = 1000",
                      "Poisson ratio = 0.3"});
    };
    const Run run(
      file("balls.prm",
           body("upper", "1") + (on_another ? body("lower", "-1") : "") +
             section("Boundary conditions",
                     {on_another
                        ? "Prescribed points = 0;0;1 : 0;0;-0.01 | 0;0;-1 : 0;0;0.01"
                        : "Prescribed points = 0;0;1 : 0;0;-0.01"}) +
             section("Contact pair c", {"Boundary = upper.0",
                                        on_another ? "Obstacle = boundary : lower.0"
                                                   : "Obstacle = plane : 0;0;0; 0;0;1",
                                        "Law = frictionless"})),
      exactly);
    return run.converged ? run.summary()["contact"]["normal_force"].get<double>() : 0.;
  }

  // A punch whose face is inclined by 10 degrees and stands on its edge.
  unsigned int on_an_edge(const std::string &side)
  {
    const Run run(
      file("edge.prm",
           brick("plate", "3,2,1", "6,4,2", "-1;-0.5;-1") +
             brick("punch", "1,1,1", "3,3,3", "0;0;0", "0;0;0;0;-1;0;10") +
             section("Boundary conditions",
                     {"Prescribed displacement = plate.bottom : 0; 0; 0 | "
                      "punch.top : 0; 0; -0.01"}) +
             section("Contact pair c",
                     {"Boundary = punch.bottom", "Obstacle = boundary : plate.top",
                      "Law = frictionless", "Slave side = " + side})),
      {});
    return n_warnings(run, "stands on an edge");
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string method : {"newton", "newton multigrid", "mpgp"})
    {
      const Settings settings{"Contact solver/Method=" + method};
      out() << method << ": one pressure in a box " << yes(in_a_box(settings) < 1e-8)
            << ", on a plate pushed with 0.299 " << on_a_plate("0.299", "0.3", settings)
            << ", 0.301 " << on_a_plate("0.301", "0.3", settings)
            << ", without friction 0.01 " << on_a_plate("0.01", "0", settings)
            << std::endl;
    }
  const double force = ball_on_plate(0., "20,20,2");
  out() << "a ball on a plate, whose mesh does not matter: moved "
        << yes(std::abs(ball_on_plate(0.2, "20,20,2") / force - 1.) < 1e-6)
        << ", coarser " << yes(std::abs(ball_on_plate(0.1, "7,9,1") / force - 1.) < 1e-6)
        << std::endl;
  const double on_plane = ball(false);
  out() << "two balls bear what one does on the plane between them, to 1 %: "
        << yes(on_plane > 0. && std::abs(ball(true) / on_plane - 1.) < 0.01) << std::endl
        << "half a ball of a few cells: parts " << n_parts_of_ball() << std::endl
        << "on an edge: warnings " << on_an_edge("boundary") << ", from the flat side "
        << on_an_edge("obstacle") << ", automatic " << on_an_edge("automatic")
        << std::endl;
}
