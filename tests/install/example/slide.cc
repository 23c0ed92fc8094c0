#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>
#include <nlohmann/json.hpp>
#include <iostream>

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  stiction::Parameters parameters;
  parameters.read(argv[1], {"Friction/Coefficient=0.1"});
  stiction::ContactProblem problem(parameters, MPI_COMM_WORLD);
  const bool certified = problem.run();
  std::cout << problem.summary()["contact"]["force_on_body"] << std::endl;
  return certified ? 0 : 2;
}
