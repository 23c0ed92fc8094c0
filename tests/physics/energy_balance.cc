// The work of loads, supports and obstacles in a step is what the energy of the body
// grows by, what friction dissipates, and the trace of the length of the step: each
// from its own data, for bodies that are dragged back, obstacles that are pressed or
// turn the frames, and on refined meshes. The trace vanishes with the number of steps.

#include "tests.h"

#include <cmath>

using namespace stiction;

namespace
{
  const Settings brick = {
    "Geometry/Table 1 level=0",      "Geometry/Lengths=4,3,1",
    "Geometry/Subdivisions=4,3,1",   "Geometry/Global refinement=1",
    "Boundary conditions/Traction=", "Contact solver/Tolerance=1e-10",
    "Friction/Coefficient=0.3"};
  const std::string top = "Boundary conditions/Prescribed displacement=top : ";

  // Pressed, dragged by more than it takes to slip, and brought back.
  const std::string there_and_back = "1e-3*max(0, min(t - 1, 3 - t)); 0; -1e-4*min(t, 1)";

  // Of the terms of all steps.
  struct Sums
  {
    unsigned int n = 0, n_unknown = 0;
    double worst = 0., dissipated = 0., least_dissipated = 0., trace = 0.,
           largest_energy = 0., supports = 0., change = 0.;
  };

  Sums sums_of(const Run &run)
  {
    Sums sums;
    for (const auto &step : run.summary()["steps"])
      {
        const auto &energy = step.at("energy");
        ++sums.n;
        if (energy["balance_error"].is_null())
          ++sums.n_unknown;
        else
          sums.worst = std::max(sums.worst, energy["balance_error"].get<double>());
        const double dissipated = energy["dissipated"];
        sums.dissipated += dissipated;
        sums.least_dissipated = std::min(sums.least_dissipated, dissipated);
        sums.trace += energy["time_stepping"].get<double>();
        sums.supports += energy["work_supports"].get<double>();
        sums.change += energy["elastic_energy_change"].get<double>();
        sums.largest_energy =
          std::max(sums.largest_energy, energy["elastic_energy"].get<double>());
      }
    return sums;
  }

  Sums check(const std::string &what, const Settings &settings,
             const unsigned int n_steps)
  {
    const Run run(shipped("brick.prm"), settings);
    const Sums sums = sums_of(run);
    out() << "  " << what << ": certified " << yes(run.converged) << ", in all steps "
          << yes(sums.n == n_steps) << ", the balance holds to 1e-8 "
          << yes(sums.worst < 1e-8) << ", friction gives no energy "
          << yes(sums.least_dissipated >= -1e-9 * sums.largest_energy) << std::endl;
    return sums;
  }

  void check(const std::string &method)
  {
    out() << method << ":" << std::endl;
    const Settings all     = brick + Settings{"Contact solver/Method=" + method};
    const Settings dragged = all + Settings{top + there_and_back, "Time/End=3"};
    const Sums few  = check("there and back", dragged + Settings{"Time/Steps=6"}, 6);
    const Sums many = check("with more steps", dragged + Settings{"Time/Steps=24"}, 24);
    out() << "    more is dissipated than the body holds "
          << yes(few.dissipated > few.largest_energy) << std::endl
          << "    with less that is left over by their length "
          << yes(std::abs(many.trace) < 0.5 * std::abs(few.trace)) << std::endl;
    check("loads alone",
          all +
            Settings{"Boundary conditions/Traction=top : 1e7*sin(3*t); 0; -4e7*min(t, "
                     "1) | right : 0; 1e6*t; 0",
                     "Boundary conditions/Prescribed displacement=left : 0; 0; 0",
                     "Time/End=2", "Time/Steps=4"},
          4);
    check("a gap that closes",
          all + Settings{top + "2e-4*t; 0; 0",
                         "Boundary conditions/Initial gap=3e-5 - 1e-4*t", "Time/Steps=3"},
          3);
    check("a sphere pressed and drawn along",
          all + Settings{top + "0; 0; 0",
                         "Boundary conditions/Obstacle=sphere : 2; 1.5; -2; 2",
                         "Boundary conditions/Obstacle force=0; 0; 1e7*min(t, 1)",
                         "Boundary conditions/Obstacle displacement=1e-4*max(0, t - 1); "
                         "0; 0",
                         "Time/Start=0.25", "Time/End=2", "Time/Steps=0.5, 1, 1.5, 2"},
          4);
    check("a sphere that a formula moves",
          all + Settings{top + "0; 0; 0",
                         "Boundary conditions/Obstacle=sphere : 1.7 + 0.3*t; 1.5; "
                         "-1.985; 2",
                         "Time/Steps=0.25, 0.5, 1"},
          3);
    check("one that is pressed and turned",
          all + Settings{top + "0; 0; 0",
                         "Boundary conditions/Obstacle=sphere : 2; 1.5; -2; 2",
                         "Boundary conditions/Obstacle force=0; 0; 1e7",
                         "Boundary conditions/Obstacle rotation=2; 1.5; -2; 0; 1; 0; "
                         "1e-4*t",
                         "Time/Steps=3"},
          3);
    check("a small one, before which nodes come and go",
          all + Settings{top + "0; 0; 0",
                         "Boundary conditions/Obstacle=sphere : 1+2*t; 1.5; -0.0999; 0.1",
                         "Time/Steps=0.25, 0.5, 1"},
          3);
    const Run refined(shipped("brick.prm"),
                      dragged +
                        Settings{"Time/Steps=1, 2, 3", "Refinement/Adaptive steps=1"});
    const Sums sums = sums_of(refined);
    out() << "  refined: certified " << yes(refined.converged)
          << ", no balance in steps whose mesh changed "
          << yes(sums.n == 3 && sums.n_unknown == 2 && sums.worst < 1e-8) << std::endl;

    // forces of an interpolated displacement are thousands of times too large there
    const Settings soft =
      dragged + Settings{"Time/Steps=1, 2, 3", "Material/Poisson ratio=0.4999"};
    const Sums changing =
      sums_of({shipped("brick.prm"), soft + Settings{"Refinement/Adaptive steps=1"}});
    const Sums fixed =
      sums_of({shipped("brick.prm"), soft + Settings{"Geometry/Global refinement=2"}});
    const auto is_close = [](const double a, const double b) {
      return std::abs(a - b) < 0.1 * std::abs(b);
    };
    out() << "    nearly incompressible: the terms are those of a fine mesh "
          << yes(is_close(changing.supports, fixed.supports) &&
                 is_close(changing.dissipated, fixed.dissipated) &&
                 is_close(changing.change, fixed.change))
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string method : {"newton", "newton multigrid"})
    check(method);
  out() << "one step: no list of steps "
        << yes(!Run(shipped("brick.prm"), brick + Settings{top + there_and_back})
                  .summary()
                  .contains("steps"))
        << std::endl;
}
