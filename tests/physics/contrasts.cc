// A brick of two layers, one up to 10^12 times softer than the other, above or
// below. A soft layer far from the contact face moves by up to 10^9 m, which
// must not make the gaps at the contact face seem small: answers of different
// methods that are certified agree, and each method certifies every one.
// Certified with the displacement of the whole body as the scale of gaps, the
// forces differed by 8e-6 at a contrast of 10^4 and by 12 % at 10^12.

#include "tests.h"

#include <algorithm>
#include <array>
#include <cmath>

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto force = [](const Run &run) {
    return run.summary()["contact"]["force_on_body"].get<std::array<double, 3>>();
  };
  for (const std::string where : {"above", "below"})
    for (const int exponent : {0, 2, 4, 6, 8, 10, 12})
      {
        const std::string stiff = "isotropic; 2.119e11; 0.277";
        const std::string soft =
          "isotropic; 2.119e" + std::to_string(11 - exponent) + "; 0.277";
        unsigned int n_certified = 0;
        double largest           = 0.;
        std::array<double, 3> reference{};
        for (const std::string method :
             {"newton", "gauss seidel", "mpgp", "admm", "newton multigrid"})
          {
            const Run run(shipped("brick.prm"),
                          {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                           "Geometry/Subdivisions=8,6,2", "Geometry/Global refinement=0",
                           "Material/Material ids=if(z > 0.5, 1, 0)",
                           "Material/Materials=0 : " + (where == "above" ? stiff : soft) +
                             " | 1 : " + (where == "above" ? soft : stiff),
                           "Contact solver/Method=" + method,
                           "Contact solver/Tolerance=1e-8"});
            if (!run.converged)
              continue;
            const auto f = force(run);
            if (++n_certified == 1)
              reference = f;
            double difference = 0., size = 0.;
            for (unsigned int c = 0; c < 3; ++c)
              {
                difference = std::hypot(difference, f[c] - reference[c]);
                size       = std::hypot(size, reference[c]);
              }
            largest = std::max(largest, difference / size);
          }
        out() << "softer by 10^" << exponent << " " << where << ": certified by "
              << n_certified << " of 5 methods, their forces agree to 1e-6 "
              << yes(largest < 1e-6) << std::endl;
      }
}
