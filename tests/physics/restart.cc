// A run of six steps, and one that ends after three and goes on from its checkpoint:
// on as many ranks they have the same displacement and the same contact forces, bit
// by bit, and so nothing but the checkpoint is remembered from step to step; from two
// ranks to one they agree to 1e-8.

#include "tests.h"

#include <deal.II/lac/la_parallel_vector.h>

using namespace stiction;

namespace
{
  const Settings brick = {
    "Geometry/Table 1 level=0",      "Geometry/Lengths=4,3,1",
    "Geometry/Subdivisions=4,3,1",   "Geometry/Global refinement=1",
    "Boundary conditions/Traction=", "Contact solver/Tolerance=1e-9",
    "Friction/Coefficient=0.3"};

  // Pressed, dragged, and brought back after t = 3 so that memory counts.
  const std::string moved = "Boundary conditions/Prescribed displacement=top : "
                            "1e-3*if(t < 3, t, 6 - t); 2e-4*t; -1e-4*min(t, 1)";
  const Settings dragged  = brick + Settings{moved};
  const Settings three    = {"Time/Steps=1, 2, 3", "Time/Checkpoint every=2"};
  const Settings six      = {"Time/Steps=1, 2, 3, 4, 5, 6"};

  bool is_same(const Run &a, const Run &b)
  {
    LA::Vector difference = a.problem->state().u;
    const bool is_as_long =
      difference.size() == b.problem->state().u.size() &&
      a.problem->state().lambda.size() == b.problem->state().lambda.size();
    if (!is_as_long || !a.converged || !b.converged)
      return false;
    difference -= b.problem->state().u;
    return difference.linfty_norm() == 0. &&
           a.problem->state().lambda == b.problem->state().lambda &&
           a.problem->state().distances == b.problem->state().distances;
  }

  void check(const std::string &name, const Settings &settings,
             const Settings &other_loads = {})
  {
    const Run straight(shipped("brick.prm"), settings + six);
    {
      const Run first(shipped("brick.prm"), settings + three);
    }
    const Run then(shipped("brick.prm"), settings + other_loads + six, "results");
    out() << name << ": the same bits " << yes(is_same(then, straight)) << std::endl;

    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
      return;
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        const Run alone(shipped("brick.prm"), settings + other_loads + six, "results",
                        MPI_COMM_SELF);
        out() << "  on one rank: the same forces to 1e-8 "
              << yes(alone.converged && distance(alone, straight) < 1e-8) << std::endl;
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string method : {"newton", "gauss seidel", "newton multigrid"})
    {
      const Settings chosen = dragged + Settings{"Contact solver/Method=" + method};
      check(method, chosen);
      check("  refined in every step", chosen + Settings{"Refinement/Adaptive steps=1"});
      check("  an obstacle pressed on and drawn along",
            chosen + Settings{"Boundary conditions/Prescribed displacement=top : 0; 0; 0",
                              "Boundary conditions/Obstacle=sphere : 2; 1.5; -10; 10",
                              "Boundary conditions/Obstacle displacement="
                              "1e-3*if(t < 3, t, 6 - t); 0; 0",
                              "Boundary conditions/Obstacle force=0; 0; 1e7"});
    }
  check("other loads than the first run had, from where it ended",
        dragged +
          Settings{"Boundary conditions/Traction=3 : if(t < 3.5, 0, 1e7*t); 0; 0"},
        {"Boundary conditions/Traction=3 : 1e7*t; 0; 0"});
}
