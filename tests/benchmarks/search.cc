// benchmark_search FIRST LAST: the random problems of these numbers by all
// methods, a line of JSON for each ('./run benchmark search').

#include "../random_problem.h"

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc != 3)
    {
      std::cerr << "benchmark_search FIRST LAST" << std::endl;
      return 1;
    }
  for (unsigned long number = std::stoul(argv[1]); number <= std::stoul(argv[2]);
       ++number)
    {
      const RandomProblem problem(number);
      const Comparison comparison = solve_by_all_methods(problem);
      nlohmann::json line         = {{"number", number},
                                     {"description", problem.description},
                                     {"tolerance", comparison.tolerance},
                                     {"agreement", comparison.agreement()},
                                     {"file", problem.file},
                                     {"settings", problem.settings}};
      for (const auto &outcome : comparison.outcomes)
        line["methods"].push_back({{"method", outcome.method},
                                   {"certified", outcome.certified},
                                   {"distance", outcome.distance},
                                   {"seconds", outcome.seconds},
                                   {"reason", outcome.reason}});
      std::cout << line << std::endl;
    }
}
