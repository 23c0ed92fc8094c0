// A body that its support moves as a whole, along a foundation that it just
// touches or away from it: there are no forces but the rounding of K u, and
// every method certifies that there are none. Pressed on by a millionth of its
// size, all of it slips, and all methods find the same forces. A body that another one
// takes along, glued to it or pushed, moves like that one.

#include "several_bodies.h"

#include <array>

namespace
{
  void take_along(const std::string &law, const std::string &moved)
  {
    const Run run(
      file("along.prm",
           brick("lower", "2,2,1", "4,4,2", "0;0;-1") +
             brick("upper", "2,2,1", "3,3,2", "0;0;0") +
             section("Boundary conditions",
                     {"Prescribed displacement = lower.bottom : " + moved}) +
             section("Contact pair joint",
                     {"Boundary = upper.bottom", "Obstacle = boundary : lower.top",
                      "Law = " + law,
                      "Coefficient = " + std::string(law == "coulomb" ? "0.3" : "")})),
      {"Contact solver/Method=newton multigrid"});
    double farthest = 0.;
    for (const auto &node : run.problem->elasticity().body().locally_owned_nodes())
      for (unsigned int c = 0; c < 3; ++c)
        farthest = std::max(farthest, std::abs(run.problem->state().u(node.dofs[c]) -
                                               (c == 2 ? 1e-3 : 0.)));
    out() << law << ", by itself " << yes(certified_alone(run)) << ", forces "
          << (run.problem->state().lambda.isZero(0.) ? "none" : "some")
          << ", all of both moved alike to 1e-12 "
          << yes(dealii::Utilities::MPI::max(farthest, MPI_COMM_WORLD) < 1e-12)
          << std::endl;
  }

  // A foam of the modulus 0.01 on a steel block that is moved by 10, below a cap of foam
  // that is moved as far and pressed by 0.001 of 20: both bear 5e-5, which is rounding
  // beside steel.
  void press_foam()
  {
    const std::string steel = "210000", foam = "0.01", none = "0;0;0;0;0;1;0";
    const auto pair = [](const std::string &above, const std::string &below) {
      return section("Contact pair " + above,
                     {"Boundary = " + above + ".bottom",
                      "Obstacle = boundary : " + below + ".top", "Law = frictionless"});
    };
    const Run run(
      file("foam.prm",
           brick("steel", "10,10,10", "3,3,3", "0;0;-10", none, steel) +
             brick("foam", "10,10,10", "2,2,2", "0;0;0", none, foam) +
             brick("cap", "10,10,10", "3,3,3", "0;0;10", none, foam) +
             section("Boundary conditions",
                     {"Prescribed displacement = steel.bottom : 10;0;0 | cap.top : "
                      "10;0;-0.001 | foam.left : 10; free; free"}) +
             pair("foam", "steel") + pair("cap", "foam")),
      {"Contact solver/Method=newton multigrid", "Material/Poisson ratio=0"});
    const auto &lambda   = run.problem->state().lambda;
    const double bearing = lambda.head(run.problem->contact_surface().n_nodes()).sum();
    out() << "foam below a cap: certified " << yes(run.converged)
          << ", not without force "
          << yes(!run.converged || std::abs(bearing / 1e-4 - 1.) < 1e-2) << std::endl;
  }

  // A cube of 10 that is moved by 300, and bears 1 N in the next step.
  void load_later(const std::string &method)
  {
    const Run run(
      file("later.prm",
           section("Geometry", {"Type = brick", "Lengths = 10,10,10",
                                "Subdivisions = 3,3,3", "Global refinement = 1"}) +
             section("Material", {"Young's modulus = 210000", "Poisson ratio = 0.3"}) +
             section("Time", {"Steps = 1, 2"}) +
             section("Boundary conditions",
                     {"Prescribed displacement = top : 300*min(t,1); 0; free",
                      "Traction = right : 0; 0; -1e-2*max(t-1,0)",
                      "Contact boundary = bottom", "Obstacle = foundation"}) +
             section("Friction", {"Law = coulomb", "Coefficient = 0.3"})),
      {"Contact solver/Method=" + method});
    const double force = run.summary()["contact"]["normal_force"].get<double>();
    out() << method << ", loaded after it was moved: certified only if right "
          << yes(!run.converged || std::abs(force - 1.) < 1e-5) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string moved : {"1e-3;0;0", "1e-3;0;1e-3", "1e-3;0;-1e-6"})
    for (const std::string law : {"coulomb", "frictionless"})
      {
        double first = -1.;
        for (const std::string method :
             {"newton", "newton multigrid", "gauss seidel", "mpgp", "admm"})
          {
            const Run run(shipped("brick.prm"),
                          {"Geometry/Table 1 level=0", "Geometry/Lengths=2,2,1",
                           "Geometry/Subdivisions=3,3,2", "Boundary conditions/Traction=",
                           "Boundary conditions/Prescribed displacement=5:" + moved,
                           "Friction/Law=" + law, "Contact solver/Method=" + method});
            const auto &contact = run.summary()["contact"];
            const double force  = contact["normal_force"].get<double>();
            if (first < 0.)
              first = force;
            out() << moved << ", " << law << ", " << method << ": certified "
                  << yes(run.converged) << ", forces " << (force > 0. ? "yes" : "none")
                  << ", the same " << yes(std::abs(force - first) <= 1e-7 * first)
                  << ", open " << contact["open"] << ", closed " << contact["closed"]
                  << ", undecided " << contact["undecided"] << std::endl;
          }
      }
  for (const std::string law : {"tied", "coulomb", "frictionless"})
    take_along(law, "0;0;1e-3");
  press_foam();
  for (const std::string method : {"newton", "newton multigrid", "gauss seidel"})
    load_later(method);
}
