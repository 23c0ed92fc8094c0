// Blocks of steel and of rubber in turn, one on the other, held at the bottom alone: the
// steel ones are held by nothing but rubber, 21,000 times softer, which the coarse grids
// of newton multigrid have to see. The cells are cubes of half of the grids', so that
// terms of their sums are equal.

#include "several_bodies.h"

using namespace stiction;

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::string blocks, pairs;
  for (int i = 0; i < 7; ++i)
    {
      const std::string number = std::to_string(i), below = std::to_string(i - 1);
      const bool is_soft = i % 2 == 1;
      blocks += brick("b" + number, "8,8,2", is_soft ? "9,9,2" : "8,8,2",
                      (is_soft ? "0.1;0;" : "0;0;") + std::to_string(2 * i),
                      "0;0;0;0;0;1;0", is_soft ? "10" : "210000");
      if (i > 0)
        pairs +=
          section("Contact pair j" + number, {"Boundary = b" + number + ".bottom",
                                              "Obstacle = boundary : b" + below + ".top",
                                              "Law = coulomb", "Coefficient = 0.4"});
    }
  const Run run(
    file("stack.prm", blocks +
                        section("Boundary conditions",
                                {"Prescribed displacement = b0.bottom : 0; 0; 0",
                                 "Traction = b6.top : 0.05; 0; -1"}) +
                        pairs),
    {"Contact solver/Method=newton multigrid"});
  const auto solver = run.summary()["solver"];
  out() << "certified " << yes(certified_alone(run)) << ", at most 40 iterations "
        << yes(solver["krylov_iterations"].get<int>() <= 40) << std::endl;
}
