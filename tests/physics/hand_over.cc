// What newton multigrid comes no closer to, friction ellipses thirty times as long as
// wide and more, is certified all the same: the dual method newton goes on, with the
// forces that it finds alone, over several times too.

#include "tests.h"

using namespace stiction;

namespace
{
  void check(const std::string &name, const Settings &settings,
             const std::string &file = shipped("orthotropic_friction.prm"))
  {
    const Settings all =
      Settings{"Friction/Coefficient=0.9; 0.03", "Contact solver/Tolerance=1e-10",
               "Output/Write solution=false"} +
      settings;
    const Run alone(file, all + Settings{"Contact solver/Method=newton"});
    const Run handed(file, all + Settings{"Contact solver/Method=newton multigrid"});
    const auto solver = handed.summary()["solver"];
    out() << name << ": certified " << yes(alone.converged && handed.converged)
          << ", handed over " << yes(solver.value("handed_over_to", "") == "newton")
          << ", same forces to 1e-6 " << yes(distance(handed, alone) < 1e-6) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check("moved", {"Friction/Coefficient=0.9; 0.02"});
  check("two steps", {"Time/End=1", "Time/Steps=2",
                      "Boundary conditions/Prescribed displacement=right : 0; free; free "
                      "| top : 0; 4e-5*t; -1e-4*(1 + y/2)*t"});
  check("eight steps, the last ones without it",
        {"Geometry/Global refinement=1", "Friction/First direction=1; 1; 0",
         "Time/Steps=8",
         "Boundary conditions/Prescribed displacement=top : 1e-4*t; 1e-4*sin(6*t); "
         "-5e-4*min(2*t,1)"},
        shipped("mesh_file.prm"));
}
