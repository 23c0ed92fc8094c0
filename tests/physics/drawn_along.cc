// A block pressed on a rigid plane by 1 mm that is drawn along by up to 10^6
// times as much: every node slides, so that the friction is F times the
// pressing force, whatever the distance. Every method certifies that, and admm,
// whose weights once followed the distance, in as many iterations for each of
// them.
//
// A block pressed on a plane that is pulled to and fro by one of its sides, whose lower
// edge is in contact: the support bears F times the pressing force, that of the edge's
// own nodes included, against the way it goes. So does it hold a block whose plane is
// drawn along.

#include "tests.h"

#include <array>
#include <cmath>

namespace
{
  const Settings block = {
    "Geometry/Table 1 level=0",      "Geometry/Lengths=2,2,1",
    "Geometry/Subdivisions=4,4,2",   "Geometry/Global refinement=0",
    "Boundary conditions/Traction=", "Boundary conditions/Pressure=top : 1e6",
    "Contact solver/Tolerance=1e-8"};

  // What the support of the left side exerts and friction add up to nothing; that is F
  // times the normal force, against the way.
  void pull(const Method &method, const std::string &what, const Settings &settings,
            const double against)
  {
    const Run run(shipped("brick.prm"), block + settings + method.settings);
    const auto summary  = run.summary();
    const double pulled = summary["reactions"]["boundaries"][0]["force"][0];
    const auto force = summary["contact"]["force_on_body"].get<std::array<double, 3>>();
    double lost      = 0.;
    if (summary.contains("steps") && summary["steps"].is_array())
      for (const auto &step : summary["steps"])
        lost = std::max(lost, step["energy"]["balance_error"].get<double>());
    out() << what << ", " << method.name << ": certified " << yes(run.converged)
          << ", no node sticks " << yes(summary["contact"]["stick"] == 0)
          << ", friction is F N against the way "
          << yes(std::abs(force[0] / force[2] - 0.3 * against) < 1e-6)
          << ", and the support's " << yes(std::abs(pulled + force[0]) < 1e-6 * force[2])
          << ", energy balances " << yes(lost < 1e-8) << std::endl;
  }
} // namespace

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

  for (const Method &method : all_methods())
    {
      const std::string held = "Boundary conditions/Prescribed displacement=left : ";
      pull(method, "pulled", {held + "0.1; 0; free"}, -1.);
      pull(method, "to and fro",
           {held + "0.1*min(t, 2 - t); 0; free", "Time/Steps=1, 2", "Time/End=2"}, 1.);
      pull(method, "with its plane",
           {held + "0; 0; free", "Boundary conditions/Obstacle displacement=0.1; 0; 0"},
           1.);

      const Run run(shipped("brick.prm"), block + method.settings +
                                            Settings{held + "0.1*min(t, 1); 0; free",
                                                     "Time/Steps=1, 2, 3", "Time/End=3"});
      const auto force =
        run.summary()["contact"]["force_on_body"].get<std::array<double, 3>>();
      out() << "pulled and held, " << method.name << ": certified " << yes(run.converged)
            << ", friction stays " << yes(std::abs(force[0] / force[2] + 0.3) < 1e-6)
            << std::endl;
    }
}
