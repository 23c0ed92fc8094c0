// A step of a history begins where the steps before lead to: the second one of an
// obstacle that moves on is guessed from rest and the first, whatever its length, and
// takes next to no Newton steps. Where the obstacle has stopped, or presses with the same
// force again, it begins where the first one ended, and takes none either.

#include "tests.h"

#include <fstream>

using namespace stiction;

namespace
{
  // The column newton_steps of energy.csv.
  std::vector<unsigned int> newton_steps()
  {
    MPI_Barrier(MPI_COMM_WORLD); // rank 0 writes it
    std::ifstream file("results/energy.csv");
    std::vector<unsigned int> steps;
    std::string line;
    for (std::getline(file, line); std::getline(file, line);)
      {
        std::istringstream row(line);
        std::string cell;
        for (unsigned int column = 0; column <= 10; ++column)
          std::getline(row, cell, ',');
        steps.push_back(static_cast<unsigned int>(std::stoul(cell)));
      }
    return steps;
  }

  void check(const std::string &name, const Settings &obstacle)
  {
    Settings settings = {"Geometry/Table 1 level=0",
                         "Geometry/Lengths=4,3,1",
                         "Geometry/Subdivisions=4,3,1",
                         "Geometry/Global refinement=1",
                         "Contact solver/Method=newton multigrid",
                         "Contact solver/Tolerance=1e-8",
                         "Friction/Coefficient=0.3",
                         "Boundary conditions/Traction=",
                         "Boundary conditions/Prescribed displacement=top : 0; 0; 0",
                         "Time/Steps=1, 2.5, 3",
                         "Output/Write solution=false"};
    settings.insert(settings.end(), obstacle.begin(), obstacle.end());
    const Run run(shipped("brick.prm"), settings);
    const auto steps = newton_steps();
    const auto sum   = run.problem->state().lambda.sum();
    out() << name << ": certified " << yes(run.converged && sum > 0.) << ", three steps "
          << yes(steps.size() == 3) << ", the first takes more than two Newton steps "
          << yes(steps.at(0) > 2) << ", the others one at most "
          << yes(steps.at(1) <= 1 && steps.at(2) <= 1) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string obstacle = "Boundary conditions/Obstacle";
  const std::string moved    = obstacle + " displacement=";
  check("moves on",
        {obstacle + "=plane : 0; 0; 0; 0; 0; 1", moved + "1e-5*t; 0; 1e-4*t"});
  check("has stopped", {obstacle + "=plane : 0; 0; 0; 0; 0; 1",
                        moved + "1e-5*min(t, 1); 0; 1e-4*min(t, 1)"});
  check("presses again",
        {obstacle + "=plane : 0; 0; 0; 0; 0; 1", obstacle + " force=0; 0; 1e7"});
}
