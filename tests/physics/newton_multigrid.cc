// The Newton method in displacements on the reference brick: the answers that
// two independent programs agree on, with geometric and with algebraic
// multigrid; the contact forces of the dual Newton method to 1e-6, node by
// node; at most 12 steps on the mesh itself for coefficients from 0 to 1, and a
// certificate also for 2 and 5; one product with K more or less, nothing more,
// on any number of ranks.

#include "tests.h"

#include <cmath>

namespace
{
  Run solve(std::vector<std::string> settings, const std::string &method)
  {
    settings.push_back("Contact solver/Method=" + method);
    settings.emplace_back("Contact solver/Tolerance=1e-8");
    return Run(shipped("brick.prm"), settings);
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string law : {"coulomb", "given", "frictionless"})
    for (const std::string level : {"1", "2", "3"})
      {
        const std::vector<std::string> settings = {"Geometry/Table 1 level=" + level,
                                                   "Friction/Law=" + law,
                                                   "Friction/Slip stress=1.5e7"};
        const Run dual                          = solve(settings, "newton");
        out() << law << ", k = " << level << ":";
        for (const std::string type : {"multigrid", "amg"})
          {
            std::vector<std::string> with = settings;
            with.push_back("Stiffness solver/Type=" + type);
            const Run run      = solve(with, "newton multigrid");
            const auto &counts = run.summary()["contact"];
            const auto &others = dual.summary()["contact"];
            out() << " " << type << " certified " << yes(run.converged)
                  << ", forces of the dual method to 1e-6 "
                  << yes(distance(run, dual) < 1e-6) << ", same states "
                  << yes(counts["open"] == others["open"] &&
                         counts["slip"] == others["slip"] &&
                         counts["stick"] == others["stick"])
                  << ";";
          }
        out() << std::endl;
      }

  for (const std::string F : {"0", "0.1", "0.3", "0.6", "1", "2", "5"})
    for (const std::string refinement : {"2", "3"})
      {
        const Run run =
          solve({"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                 "Geometry/Subdivisions=4,3,1",
                 "Geometry/Global refinement=" + refinement, "Friction/Coefficient=" + F},
                "newton multigrid");
        const auto &solver = run.summary()["solver"];
        out() << "F = " << F << ", refined " << refinement << " times: certified "
              << yes(run.converged) << ", at most 12 steps "
              << yes(solver["newton_steps"].get<unsigned int>() <= 12)
              << ", at most 30 Krylov iterations "
              << yes(solver["krylov_iterations"].get<unsigned int>() <= 30) << std::endl;
      }
}
