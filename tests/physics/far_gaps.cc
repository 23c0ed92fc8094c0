// Half a ball on a plane, pressed in by so little that it touches at one node
// and the gaps of the others are up to 10^5 times what anything moves. A
// pressure across them is no worse than across a gap that is just open: newton
// multigrid, whose linear residual is such a pressure, certifies the same
// forces as newton, also where a force presses the plane on and has to be
// found.

#include "tests.h"

#include <cmath>

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::vector<std::pair<std::string, Settings>> cases = {
    {"moved", {"Boundary conditions/Prescribed displacement=flat : 0; 0; -1e-4"}},
    {"moved aside",
     {"Boundary conditions/Prescribed displacement=flat : 2e-6; 0; -1e-4"}},
    {"pressed",
     {"Boundary conditions/Prescribed displacement=flat : 0; 0; 0",
      "Boundary conditions/Obstacle force=0; 0; 1e8"}}};
  for (const auto &[name, settings] : cases)
    {
      double forces[2] = {};
      bool certified   = true;
      unsigned int k   = 0;
      for (const std::string method : {"newton", "newton multigrid"})
        {
          const Run run(shipped("half_ball.prm"),
                        settings + Settings{"Geometry/Global refinement=3",
                                            "Boundary conditions/Obstacle=plane : 0; 0; "
                                            "0; 0; 0; 1",
                                            "Boundary conditions/Initial gap=0",
                                            "Contact solver/Method=" + method});
          certified   = certified && run.converged;
          forces[k++] = run.summary()["contact"]["normal_force"].get<double>();
        }
      out() << name << ": certified " << yes(certified) << ", forces agree to 1e-7 "
            << yes(std::abs(forces[1] - forces[0]) <= 1e-7 * forces[0]) << std::endl;
    }
}
