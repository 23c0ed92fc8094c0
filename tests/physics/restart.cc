// A run of six steps, and one that ends after three and goes on from its checkpoint:
// on as many ranks they have the same displacement and the same contact forces, bit
// by bit, and so nothing but the checkpoint is remembered from step to step; from two
// ranks to one they agree to 1e-8.

#include "tests.h"

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <cmath>
#include <vector>

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

  // How far the answers are apart, relative; 0 if they are the same bits.
  double error(const Run &a, const Run &b)
  {
    const LA::Vector &u   = b.problem->state().u;
    LA::Vector difference = a.problem->state().u;
    if (!a.converged || !b.converged || difference.size() != u.size())
      return 1e300;
    difference -= u;
    return std::max(difference.linfty_norm() / u.linfty_norm(), distance(a, b));
  }

  // Whether all steps have the same works and energies, those of loads and supports
  // together: other loads at supported nodes leave the supports another part of the work.
  bool have_same_works(const Run &a, const Run &b)
  {
    const auto terms = [](const auto &step) {
      const auto &energy = step["energy"];
      return std::vector<double>{energy["work_loads"].template get<double>() +
                                   energy["work_supports"].template get<double>(),
                                 energy["work_obstacles"],
                                 energy["elastic_energy_change"],
                                 energy["dissipated"],
                                 energy["time_stepping"],
                                 energy["elastic_energy"]};
    };
    const auto steps = a.summary()["steps"], others = b.summary()["steps"];
    bool is_so = steps.size() == 6 && others.size() == 6;
    for (std::size_t k = 0; is_so && k < 6; ++k)
      for (std::size_t i = 0; i < 6; ++i)
        is_so = is_so && std::abs(terms(steps[k])[i] - terms(others[k])[i]) <=
                           1e-7 * terms(others[k]).back();
    return is_so;
  }

  // @param repeats_itself whether such a run finds the same bits each time on several
  //   ranks: MUMPS does not where cells are refined locally.
  void check(const std::string &name, const Settings &settings,
             const bool repeats_itself = true, const Settings &other_loads = {})
  {
    const Run straight(shipped("brick.prm"), settings + six);
    {
      const Run first(shipped("brick.prm"), settings + three);
    }
    const Run then(shipped("brick.prm"), settings + other_loads + six, "results");
    const bool is_exact = is_alone() || repeats_itself;
    out() << name << ": the same " << (is_exact ? "bits " : "to 1e-12 ")
          << yes(error(then, straight) <= (is_exact ? 0. : 1e-12)) << ", the same works "
          << yes(have_same_works(then, straight)) << std::endl;
    if (is_alone())
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
  check("gauss seidel", dragged + Settings{"Contact solver/Method=gauss seidel"});
  for (const std::string method : {"newton", "newton multigrid"})
    {
      const Settings chosen = dragged + Settings{"Contact solver/Method=" + method};
      check(method, chosen);
      check("  refined in every step", chosen + Settings{"Refinement/Adaptive steps=1"},
            method != "newton");
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
        true, {"Boundary conditions/Traction=3 : 1e7*t; 0; 0"});
  const std::string aside = "Boundary conditions/Prescribed displacement=top : "
                            "1e-3*if(t < 3, t, 6 - t); 2e-4*t; ";
  check("other supports than the first run had, from where it ended",
        brick + Settings{aside + "if(t < 3.5, -1e-4*min(t, 1), -2e-4)"}, true,
        {aside + "-2e-4"});
}
