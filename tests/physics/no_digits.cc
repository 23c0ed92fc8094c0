// A stiff block on a layer that is up to 10^14 times softer, dragged and turned
// along a rigid plane: it moves by up to 10^14 times its strain, and of the
// forces inside it, differences of displacements, fewer and fewer digits are
// left. newton multigrid makes its contact forces from those forces, so that
// nothing seems to be lacking; where rounding is above the tolerance no method
// certifies any more, and the program says why.

#include "tests.h"

#include <stiction/output/report.h>

#include <array>
#include <cmath>

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string exponent : {"2", "6", "10", "12", "14"})
    {
      unsigned int n_certified = 0, n_told = 0, n_within = 0;
      double largest = 0.;
      std::array<double, 3> reference{};
      for (const std::string method :
           {"newton", "newton multigrid", "gauss seidel"})
        {
          const Run run(
            shipped("brick.prm"),
            {"Geometry/Table 1 level=0",
             "Geometry/Lengths=2,2,1",
             "Geometry/Subdivisions=4,4,4",
             "Geometry/Global refinement=0",
             "Material/Poisson ratio=0.3",
             "Material/Young's modulus=2e11",
             "Material/Material ids=if(z < 0.25, 1, 0)",
             "Material/Materials=1 : isotropic; 2e" + std::to_string(11 - std::stoi(exponent)) + "; 0.3",
             "Boundary conditions/Prescribed displacement=4 : 0; 0; 0",
             "Boundary conditions/Traction=1 : 2e6; 0; 5e6 | 0 : 0; 1e6; 3e6",
             "Boundary conditions/Contact boundary=5",
             "Friction/Coefficient=0.2",
             "Contact solver/Maximum iterations=300",
             "Contact solver/Method=" + method,
             "Contact solver/Tolerance=1e-8"});
          const stiction::Certificate &certificate = run.problem->certificate();
          std::cerr << exponent << ' ' << method << ' ' << run.converged << ' '
                    << certificate.rounding() << ' ' << certificate.worst()
                    << ' ' << run.summary()["contact"]["force_on_body"] << ' '
                    << run.summary()["displacement"]["max"] << ' '
                    << stiction::explain(
                         run.problem->solution(), certificate, 1e-8)
                    << std::endl;
        }
    }
}
