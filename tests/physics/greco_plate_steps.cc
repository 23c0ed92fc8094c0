// The GRECO plate loaded in 1, 5 and 20 steps, loads growing in proportion: what slips
// goes on slipping the same way, so the steps must not be seen in the answer.

#include "tests.h"

using namespace stiction;

namespace
{
  Run load(const std::string &steps)
  {
    const std::string h = "0.000625";
    return Run(shipped("greco_plate.prm"),
               {"Geometry/Lengths=0.04," + h + ",0.04", "Geometry/Subdivisions=64,1,64",
                "Boundary conditions/Prescribed points=0.04; 0; 0 : free; free; 0 "
                "| 0.04; " +
                  h + "; 0 : free; free; 0",
                "Boundary conditions/Pressure=top : 5e7*t | left : 15e7*t",
                "Contact solver/Tolerance=1e-9", "Output/Write solution=false",
                "Refinement/Estimate error=false", "Time/Steps=" + steps});
  }

  double distance_of_displacements(const Run &run, const Run &reference)
  {
    LA::Vector difference = run.problem->state().u;
    difference -= reference.problem->state().u;
    return difference.l2_norm() / reference.problem->state().u.l2_norm();
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Run at_once = load("1");
  for (const std::string steps : {"5", "20"})
    {
      const Run run = load(steps);
      out() << steps << " steps: certified " << yes(run.converged && at_once.converged)
            << ", slips and sticks "
            << yes(run.summary()["contact"]["slip"] > 0 &&
                   run.summary()["contact"]["stick"] > 0)
            << ", the forces of one step to 1e-6 " << yes(distance(run, at_once) < 1e-6)
            << ", its displacements to 1e-6 "
            << yes(distance_of_displacements(run, at_once) < 1e-6) << std::endl;
    }
}
