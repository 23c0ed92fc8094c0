// With fixed supports the work of the loads is twice the strain energy plus
// the work against the gaps plus what friction dissipates; friction
// dissipates, and changes the answer.

#include "tests.h"

#include <cmath>

using namespace stiction;

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  double without_friction = 0.;
  for (const std::string law : {"frictionless", "given", "coulomb"})
    for (const std::string gap : {"0", "1e-5*(x-2)"})
      {
        const Run run(shipped("brick.prm"),
                      {"Geometry/Table 1 level=2", "Friction/Law=" + law,
                       "Friction/Slip stress=1.5e7", "Friction/Slip stress=1.5e7",
                       "Boundary conditions/Initial gap=" + gap,
                       "Contact solver/Tolerance=1e-12"});
        const auto &energy  = run.summary()["energy"];
        const auto &lambda  = run.problem->state().lambda;
        const auto &gaps    = run.problem->contact_surface().gaps();
        const double strain = energy["strain"], work = energy["load_work"],
                     friction = energy["friction_dissipation"];
        const double balance =
          2. * strain + lambda.head(gaps.size()).dot(gaps) + friction - work;
        if (law == "frictionless" && gap == "0")
          without_friction = strain;

        out() << law << ", gap " << gap << ": certified " << yes(run.converged)
              << ", energies balance to 1e-10 " << yes(std::abs(balance) < 1e-10 * work)
              << ", friction dissipates " << (friction > 1e-3 * work ? "yes" : "no")
              << ", changes the strain energy "
              << (std::abs(strain - without_friction) > 1e-3 * strain ? "yes" : "no")
              << std::endl;
      }
}
