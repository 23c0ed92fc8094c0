// The shipped wedges, an assembly of Abaqus: driven in until all slips, the lower one
// takes W (tan(a + phi) + F) of its driver and the upper one W tan(a + phi) of its wall,
// with tan(phi) = F, by every method that certifies histories of pairs within seconds.

#include "tests.h"

#include <cmath>

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  constexpr double F = 0.15, load = 4000.;
  const double wall = load * std::tan(std::atan(F) + 10. * M_PI / 180.);
  for (const std::string method : {"newton multigrid", "newton", "admm"})
    {
      const Run run(shipped("several_bodies/wedges.prm"),
                    {"Contact solver/Method=" + method});
      const auto force_along_x = [&](const std::string &boundary) {
        for (const auto &reaction : run.summary()["reactions"]["boundaries"])
          if (reaction["name"] == boundary)
            return reaction["force"][0].get<double>();
        return std::nan("");
      };
      out() << method << ": certified " << yes(run.converged) << ", force of the driver "
            << yes(std::abs(force_along_x("Lower.grip") - wall - F * load) < 1e-5 * load)
            << ", of the wall "
            << yes(std::abs(force_along_x("Upper.grip") + wall) < 1e-5 * load)
            << std::endl;
    }
}
