// Random assemblies: 'newton' and 'newton multigrid' certify the same forces, or both say
// that no equilibrium exists, and seldom does the second need a method to fall back
// to. A range of others: random_assemblies.release FIRST LAST.

#include "../how_it_ends.h"
#include "random_assembly.h"

#include <string>

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int first = argc > 2 ? std::stoi(argv[1]) : 1;
  const unsigned int last  = argc > 2 ? std::stoi(argv[2]) : 12;
  const Settings multigrid = {"Contact solver/Method=newton multigrid"};
  unsigned int certified = 0, alone = 0;
  for (unsigned int number = first; number <= last; ++number)
    {
      const std::string prm = file("assembly.prm", RandomAssembly(number).text);
      const std::string end = how_it_ends(prm);
      if (end != "certified")
        {
          const std::string other = how_it_ends(prm, multigrid);
          if (end == "not converged" || other != end)
            out() << number << ": newton: " << end << ", newton multigrid: " << other
                  << std::endl;
          continue;
        }
      ++certified;
      const Run newton(prm, {}), run(prm, multigrid);
      alone += certified_alone(run);
      if (argc > 2 && !certified_alone(run))
        out() << number << ": not alone" << std::endl;
      if (!run.converged)
        out() << number << ": not certified by newton multigrid" << std::endl;
      else if (const double error = distance(run, newton); error > 1e-5)
        out() << number << ": forces differ by " << error << std::endl;
    }
  const unsigned int all = last - first + 1;
  if (argc > 2)
    out() << certified << " of " << all << " certified, " << alone << " alone"
          << std::endl;
  out() << "more than half certified: " << yes(2 * certified > all)
        << ", alone but for one in four: " << yes(4 * alone >= 3 * certified)
        << std::endl;
}
