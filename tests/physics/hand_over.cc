// What newton multigrid comes no closer to, where its systems are too hard for multigrid
// and the method is not the user's choice: the dual method newton goes on, with the
// forces that it finds alone, over several steps too.

#include "tests.h"

using namespace stiction;

namespace
{
  void check(const std::string &name, const Settings &settings)
  {
    const Settings all =
      Settings{"Geometry/Table 1 level=0",      "Geometry/Lengths=4,4,1",
               "Geometry/Subdivisions=24,24,6", "Geometry/Global refinement=0",
               "Material/Poisson ratio=0.4999", "Contact solver/Tolerance=1e-8",
               "Output/Write solution=false"} +
      settings;
    const std::string brick = shipped("brick.prm");
    const Run alone(brick, all + Settings{"Contact solver/Method=newton"});
    const Run handed(brick, all + Settings{"Contact solver/Method=automatic"});
    const auto solver = handed.summary()["solver"];
    out() << name << ": certified " << yes(alone.converged && handed.converged)
          << ", handed over " << yes(solver.value("handed_over_to", "") == "newton")
          << ", same forces to 1e-6 " << yes(distance(handed, alone) < 1e-6) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check("nearly incompressible", {});
  check("two steps", {"Time/End=1", "Time/Steps=2",
                      "Boundary conditions/Traction=5 : 0; 1e6*t; -5e6*t"});
}
