// A block pressed on a rigid plane by 1 mm that is drawn along by up to 10^6
// times as much: every node slides, so that the friction is F times the
// pressing force, whatever the distance. Every method certifies that, and admm,
// whose weights once followed the distance, in as many iterations for each of
// them.

#include "tests.h"

#include <array>
#include <cmath>

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string distance : {"1", "100", "1000"})
    for (const std::string method :
         {"newton", "gauss seidel", "mpgp", "admm", "newton multigrid"})
      {
        const Run run(
          shipped("brick.prm"),
          {"Geometry/Table 1 level=0", "Geometry/Lengths=2,2,1",
           "Geometry/Subdivisions=4,4,2", "Geometry/Global refinement=0",
           "Material/Young's modulus=1e9", "Material/Poisson ratio=0.3",
           "Boundary conditions/Prescribed displacement=5 : 0; 0; 0",
           "Boundary conditions/Traction=",
           "Boundary conditions/Obstacle displacement=" + distance + "; 0; 1e-3",
           "Contact solver/Method=" + method});
        const auto force =
          run.summary()["contact"]["force_on_body"].get<std::array<double, 3>>();
        out() << "drawn along by " << distance << ", " << method << ": certified "
              << yes(run.converged) << ", friction is F N "
              << yes(std::abs(force[0] / force[2] - 0.3) < 1e-6);
        if (method == "admm")
          out() << ", in less than 60 iterations "
                << yes(run.summary()["solver"]["admm_iterations"].get<unsigned int>() <
                       60);
        out() << std::endl;
      }
}
