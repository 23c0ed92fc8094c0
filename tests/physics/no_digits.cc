// A stiff block on a layer that is up to 10^12 times softer, dragged and turned
// along a rigid plane: it moves by up to 10^12 times its strain, and of the
// forces inside it, differences of displacements, fewer and fewer digits are
// left. newton multigrid makes its contact forces from those forces, so that
// nothing seems to be lacking; where rounding is above the tolerance no method
// certifies any more, and the program says why.

#include "tests.h"

#include <stiction/output/results/report.h>

#include <array>
#include <cmath>

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const int exponent : {2, 6, 10, 12})
    {
      unsigned int n_certified = 0, n_named = 0;
      bool agree = true, is_seen = true;
      std::array<double, 3> reference{};
      for (const std::string method : {"newton", "newton multigrid"})
        {
          const Run run(
            shipped("brick.prm"),
            {"Geometry/Table 1 level=0", "Geometry/Lengths=2,2,1",
             "Geometry/Subdivisions=4,4,4", "Geometry/Global refinement=0",
             "Material/Poisson ratio=0.3", "Material/Young's modulus=2e11",
             "Material/Material ids=if(z < 0.25, 1, 0)",
             "Material/Materials=1 : isotropic; 2e" + std::to_string(11 - exponent) +
               "; 0.3",
             "Boundary conditions/Prescribed displacement=4 : 0; 0; 0",
             "Boundary conditions/Traction=1 : 2e6; 0; 5e6 | 0 : 0; 1e6; 3e6",
             "Boundary conditions/Contact boundary=5", "Friction/Coefficient=0.2",
             "Contact solver/Maximum iterations=300", "Contact solver/Method=" + method});
          const stiction::Certificate &certificate = run.problem->certificate();
          const auto force =
            run.summary()["contact"]["force_on_body"].get<std::array<double, 3>>();
          const std::string last =
            stiction::explain(run.problem->status(), certificate, 1e-8);
          n_named += last.find("double precision") != std::string::npos;
          // what is lacking in equilibrium is at least what is estimated
          is_seen = is_seen && certificate.rounding() <=
                                 certificate.body_figures().equilibrium_residual;
          if (!run.converged)
            continue;
          if (++n_certified == 1)
            reference = force;
          for (unsigned int c = 0; c < 3; ++c)
            agree =
              agree && std::abs(force[c] - reference[c]) < 1e-6 * std::abs(reference[2]);
        }
      out() << "softer by 10^" << exponent << ": certified by " << n_certified << " of 2"
            << ", their forces agree to 1e-6 " << (n_certified > 1 ? yes(agree) : "-")
            << ", rounding counts " << yes(is_seen) << ", named as the reason "
            << (n_named > 0 ? "yes" : "no") << std::endl;
    }
}
