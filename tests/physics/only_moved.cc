// A body that its support moves as a whole, along a foundation that it just
// touches or away from it: there are no forces but the rounding of K u, and
// every method certifies that there are none. Pressed on by a millionth of its
// size, all of it slips, and all methods find the same forces.

#include "tests.h"

#include <array>

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
}
