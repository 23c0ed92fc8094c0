// Twenty of the random problems of which './run benchmark search' solves
// thousands: newton certifies all of them, and no two methods certify different
// forces.

#include "../random_problem.h"

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  unsigned int not_certified = 0, different = 0, certified = 0, raised = 0;
  for (unsigned int number = 1; number <= 20; ++number)
    {
      const Comparison comparison = solve_by_all_methods(RandomProblem(number));
      raised += comparison.tolerance > Comparison().tolerance;
      for (const auto &outcome : comparison.outcomes)
        {
          not_certified += outcome.method == "newton" && !outcome.certified;
          different += outcome.certified && outcome.distance > comparison.agreement();
          certified += outcome.certified;
        }
    }
  out() << "not certified by newton: " << not_certified
        << "\ncertified and different: " << different
        << "\nwith a larger tolerance: " << raised
        << "\nmost are certified by all methods: " << yes(certified >= 100) << std::endl;
}
