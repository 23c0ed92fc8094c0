// Bodies that cover a part of a boundary, not along the edges of its faces: what loads
// and supports press on one side arrives on the other, whichever side bears the forces,
// also beside a step between bodies that lie next to each other. Nodes of which next to
// nothing is covered do not keep a method from ending.

#include <stiction/contact/interface/contact_operator.h>
#include <stiction/contact/interface/contact_surface.h>

#include "several_bodies.h"

#include <cmath>

using namespace stiction;

namespace
{
  double reaction(const Run &run, const std::string &boundary)
  {
    const nlohmann::json summary = run.summary();
    for (const auto &support : summary["reactions"]["boundaries"])
      if (support["name"] == boundary)
        return support["force"][2];
    return 0.;
  }

  // @param covered the length of what lies on 1.
  std::string plate(const std::string &covered, const std::string &on_top,
                    const std::string &pair)
  {
    return brick("lower", "1,1,0.5", "4,4,2", "0;0;0") +
           brick("upper", covered + ",1,0.5", "3,5,2", "0;0;0.5") +
           section("Boundary conditions", {on_top}) +
           section("Contact pair c",
                   {"Boundary = lower.top", "Obstacle = boundary : upper.bottom",
                    "Law = coulomb", "Coefficient = 0.3", pair}) +
           section("Contact solver", {"Tolerance = 1e-8"});
  }

  void pressed_plate(const std::string &side, const std::string &degree)
  {
    const Run run(
      file("plate.prm", plate("0.55", "Prescribed displacement = lower.bottom : 0; 0; 0",
                              "Slave side = " + side) +
                          section("Boundary conditions", {"Pressure = upper.top : 1"})),
      {"Geometry/Element degree=" + degree});
    out() << "pressed, slave side " << side << ", degree " << degree << ": certified "
          << yes(run.converged) << ", support bears 0.55 to 1e-9 "
          << yes(std::abs(reaction(run, "lower.bottom") - 0.55) < 1e-9) << std::endl;
  }

  // Two plates, the second one higher by a step, both pressed in by as much.
  void beside_a_step(const std::string &step, const std::string &degree)
  {
    const Run run(
      file("step.prm",
           brick("lower", "1,1,0.5", "4,4,2", "0;0;0") +
             brick("a", "0.5,1,0.5", "3,5,2", "0;0;0.5") +
             brick("b", "0.4,1,0.5", "2,3,2",
                   "0.55;0;" + std::to_string(0.5 + std::stod(step))) +
             section("Boundary conditions",
                     {"Prescribed displacement = lower.bottom : 0; 0; 0 | a.top : 0; 0; "
                      "-0.01 | b.top : 0; 0; -0.01-" +
                      step}) +
             section("Contact pair c",
                     {"Boundary = lower.top", "Obstacle = boundary : a.bottom, b.bottom",
                      "Slave side = boundary", "Law = coulomb", "Coefficient = 0.3"}) +
             section("Contact solver", {"Tolerance = 1e-8"})),
      {"Geometry/Element degree=" + degree});
    const double first = reaction(run, "a.top"), second = reaction(run, "b.top"),
                 sum = first + second + reaction(run, "lower.bottom");
    out() << "step " << step << ", degree " << degree << ": certified "
          << yes(run.converged) << ", both press " << yes(first < -1. && second < -1.)
          << ", as much arrives to 1e-9 " << yes(std::abs(sum) < -1e-9 * (first + second))
          << std::endl;
  }

  // Everything is moved by far more than it is strained, so that the rounding of K u is
  // large beside forces at nodes of next to no area.
  void hardly_covered_nodes()
  {
    for (const std::string covered : {"0.505", "0.51"})
      {
        const Run run(
          file("hardly.prm", plate(covered,
                                   "Prescribed displacement = lower.bottom : 0.3; 0; 0 | "
                                   "upper.top : 0.3; 0; -1e-5",
                                   "Initial gap = 1e-3*(x>0.3)\n  set Slave side = "
                                   "boundary")),
          {"Geometry/Element degree=2", "Contact solver/Method=newton multigrid"});
        const unsigned int steps = run.summary()["solver"]["newton_steps"];
        out() << "hardly covered, " << covered << ": certified alone "
              << yes(certified_alone(run)) << ", Newton steps at most 3 "
              << yes(steps <= 3) << std::endl;
      }
  }

  // Shape functions of degree 2 have integrals that nearly vanish, or are negative, where
  // a sliver of a face is covered. Of such nodes nothing is followed a thousandfold, and
  // what they have to bear others bear: energies are those of the other side.
  void slivers()
  {
    for (const std::string angle : {"0.1", "0.35", "0.6"})
      {
        const auto run = [&](const std::string &side) {
          return Run(
            file(
              "sliver.prm",
              brick("lower", "1,1,0.5", "4,4,2", "0;0;0") +
                brick("upper", "0.5,0.5,0.5", "3,3,2", "0.3;0.15;0.5",
                      "0;0;0;0;0;1;" + angle) +
                section("Boundary conditions",
                        {"Prescribed displacement = lower.bottom : 0; 0; 0",
                         "Pressure = upper.top : 1"}) +
                section("Contact pair c",
                        {"Boundary = lower.top", "Obstacle = boundary : upper.bottom",
                         "Slave side = " + side, "Law = coulomb", "Coefficient = 0.3"}) +
                section("Contact solver", {"Tolerance = 1e-8"})),
            {"Geometry/Element degree=2", "Contact solver/Method=newton multigrid"});
        };
        const Run wide = run("boundary"), narrow = run("obstacle");
        const auto energy = [](const Run &run) -> double {
          return run.summary()["energy"]["load_work"];
        };
        const ContactOperator &B = wide.problem->contact_surface().B();
        double largest           = 0.;
        for (Eigen::Index i = 0; i < B.other_side().weights.rows(); ++i)
          largest = std::max(largest, B.other_side().weights.row(i).cwiseAbs().sum());
        out() << "slivers, turned by " << angle << ": certified alone "
              << yes(certified_alone(wide) && certified_alone(narrow))
              << ", weights below 20 " << yes(largest < 20.) << ", works to 0.5 % "
              << yes(std::abs(energy(wide) / energy(narrow) - 1.) < 5e-3) << std::endl;
      }
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string degree : {"1", "2"})
    {
      for (const std::string side : {"boundary", "obstacle"})
        pressed_plate(side, degree);
      for (const std::string step : {"0", "0.02", "0.4"})
        beside_a_step(step, degree);
    }
  hardly_covered_nodes();
  slivers();
}
