// A stiff block on a layer that is up to 2e8 times softer, pressed against a
// rigid plane and dragged and turned along it: nothing but contact holds it
// where it is, and Q has a few eigenvalues far above all others. newton
// and newton multigrid certify every ratio, with the same forces; the others
// do so, too, or say that they did not converge.

#include "tests.h"

#include <array>
#include <cmath>

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string ratio : {"200", "2e3", "2e5", "2e8"})
    {
      std::array<double, 3> reference{};
      for (const std::string method :
           {"newton", "newton multigrid", "gauss seidel", "mpgp", "admm"})
        {
          const Run run(shipped("brick.prm"),
                        {"Geometry/Table 1 level=0", "Geometry/Lengths=2,2,1",
                         "Geometry/Subdivisions=10,10,4", "Geometry/Global refinement=0",
                         "Material/Poisson ratio=0.3", "Material/Young's modulus=2e11",
                         "Material/Material ids=if(z < 0.25, 1, 0)",
                         "Material/Materials=1 : isotropic; " +
                           exact(2e11 / std::stod(ratio)) + "; 0.3",
                         "Boundary conditions/Prescribed displacement=4 : 0; 0; "
                         "0",
                         "Boundary conditions/Traction=1 : 2e6; 0; 5e6 | 0 : 0; "
                         "1e6; 3e6",
                         "Boundary conditions/Contact boundary=5",
                         "Friction/Coefficient=0.5", "Contact solver/Method=" + method,
                         "Contact solver/Tolerance=1e-6"});
          const auto force =
            run.summary()["contact"]["force_on_body"].get<std::array<double, 3>>();
          if (method == "newton")
            {
              reference = force;
              out() << ratio << " times softer: newton certified " << yes(run.converged)
                    << std::endl;
              continue;
            }
          double difference = 0.;
          for (unsigned int c = 0; c < 3; ++c)
            difference = std::hypot(difference, force[c] - reference[c]);
          const bool may_fail = method != "newton multigrid";
          out() << "  " << method << " certifies the same"
                << (may_fail ? " or nothing " : " ")
                << yes((may_fail && !run.converged) ||
                       (run.converged && difference < 1e-6 * 1.6e7))
                << std::endl;
        }
    }
}
