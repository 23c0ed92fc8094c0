// The times of a load history: those asked for are met exactly, steps that cannot be
// taken are cut in half down to the smallest, and grow again after two that can.

#include "tests.h"

#include <stiction/simulation/time_steps.h>

using namespace stiction;

namespace
{
  // The times that are reached if every step longer than what is possible fails.
  void run(const std::string &name, TimeSteps steps, const double possible)
  {
    out() << name << ":";
    while (!steps.is_finished())
      {
        const double step = steps.time() - steps.reached();
        if (step <= possible)
          {
            steps.accept();
            out() << ' ' << steps.reached();
          }
        else if (!steps.cut())
          {
            out() << ", a step of " << step << " is not cut";
            break;
          }
      }
    out() << "; " << steps.n_taken() << " steps" << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  run("all succeed", TimeSteps(0., {0.1, 0.5, 2.}, 0.), 10.);
  run("one is cut twice", TimeSteps(0., {1., 2.}, 0.1), 0.3);
  run("nothing is cut", TimeSteps(0., {1., 2.}, 0.), 0.3);
  run("too short", TimeSteps(0., {1.}, 0.2), 0.1);
  const double third = 1. / 3.;
  TimeSteps thirds(0., {third, 2. * third, 1.}, 1e-3);
  thirds.cut();
  while (thirds.reached() != third)
    thirds.accept();
  out() << "a time asked for is met exactly: " << yes(thirds.reached() == third)
        << std::endl;
}
