// Friction acts on the slip of each step. A proportional path needs no steps; a block
// that is dragged and brought back is held back by friction, which a single solve at
// its last place knows nothing of; and a step that had to be cut is none other than
// the same steps asked for.

#include "tests.h"

#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>

using namespace stiction;

namespace
{
  const Settings brick = {
    "Geometry/Table 1 level=0",      "Geometry/Lengths=4,3,1",
    "Geometry/Subdivisions=4,3,1",   "Geometry/Global refinement=1",
    "Boundary conditions/Traction=", "Contact solver/Tolerance=1e-9",
    "Friction/Coefficient=0.3"};
  const std::string moved = "Boundary conditions/Prescribed displacement=top : ";

  // Pressed, dragged by more than it takes to slip, and brought back.
  const std::string there_and_back = "1e-3*max(0, min(t - 1, 3 - t)); 0; -1e-4*min(t, 1)";

  Eigen::VectorXd forces(const Settings &settings)
  {
    const Run run(shipped("brick.prm"), settings);
    return run.converged ? run.problem->state().lambda : Eigen::VectorXd();
  }

  // Relative; of something that is not certified more than everything.
  double distance(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
  {
    return a.size() == 0 || a.size() != b.size() ? 1e300 : (a - b).norm() / b.norm();
  }

  void check(const Method &method)
  {
    const Settings all          = brick + method.settings;
    const Settings proportional = all + Settings{moved + "1e-4*t; 0; -3e-4*t"};
    out() << method.name << ":" << std::endl
          << "  a proportional path, 5 steps for 1: the same forces to 1e-7 "
          << yes(distance(forces(proportional + Settings{"Time/Steps=5"}),
                          forces(proportional)) < 1e-7)
          << std::endl;

    // along x alone, since nothing spreads to the sides
    const Settings dragged =
      all + Settings{"Material/Poisson ratio=0", moved + there_and_back};
    const Run back(shipped("brick.prm"), dragged + Settings{"Time/Steps=1, 2, 3"});
    const Eigen::VectorXd &lambda   = back.problem->state().lambda;
    const std::vector<double> force = back.summary()["contact"]["force_on_body"];
    out() << "  dragged and brought back: certified " << yes(back.converged)
          << ", everywhere it slips "
          << yes(back.summary()["contact"]["slip"] ==
                 back.problem->contact_surface().n_nodes())
          << ", friction along x = F x pressing to 1e-8 "
          << yes(std::abs(force[0] / (0.3 * lambda.head(lambda.size() / 3).sum()) - 1.) <
                 1e-8)
          << std::endl;
    const Run at_once(shipped("brick.prm"), dragged + Settings{"Time/End=3"});
    out() << "  a single solve there: friction along x below 1e-6 of the pressing "
          << yes(
               std::abs(at_once.summary()["contact"]["force_on_body"][0].get<double>()) <
               1e-6 * at_once.problem->state().lambda.head(lambda.size() / 3).sum())
          << std::endl;

    const Settings history = all + Settings{moved + "2e-4*t*t; 0; -1e-4*t"};
    out() << "  steps through the same times in a list: the same forces to 1e-8 "
          << yes(distance(forces(history + Settings{"Time/Steps=4"}),
                          forces(history + Settings{"Time/Steps=0.25, 0.5, 0.75, 1"})) <
                 1e-8)
          << ", fewer steps are another path "
          << yes(distance(forces(history + Settings{"Time/Steps=2"}),
                          forces(history + Settings{"Time/Steps=4"})) > 1e-6)
          << std::endl;
  }

  // A sphere that is pressed on and dragged at once. In one step from t = 0.1 to 1 it
  // takes a Newton step more than allowed, in two it does not.
  void check_cut()
  {
    const Settings all =
      brick + Settings{"Contact solver/Method=newton multigrid",
                       "Contact solver/Tolerance=1e-11",
                       "Boundary conditions/Prescribed displacement=bottom : 0; 0; 0",
                       "Boundary conditions/Contact boundary=top",
                       "Boundary conditions/Obstacle=sphere : 2; 1.5; 6 - 0.05*t; 5",
                       "Boundary conditions/Obstacle displacement=0.01*t*t; 0; 0"};
    const Settings once =
      all + Settings{"Time/Steps=0.1, 1", "Contact solver/Maximum iterations=7"};
    const Run cut(shipped("brick.prm"), once + Settings{"Time/Smallest step=0.4"}),
      fails(shipped("brick.prm"), once),
      asked_for(shipped("brick.prm"), all + Settings{"Time/Steps=0.1, 0.55, 1"}),
      at_once(shipped("brick.prm"), all + Settings{"Time/Steps=0.1, 1"});
    LA::Vector difference = cut.problem->state().u;
    difference -= asked_for.problem->state().u;
    out() << "a step that fails: " << yes(!fails.converged) << "; cut: certified "
          << yes(cut.converged) << ", the steps asked for: forces to 1e-8 "
          << yes(distance(cut, asked_for) < 1e-8) << ", displacements to 1e-8 "
          << yes(difference.l2_norm() < 1e-8 * asked_for.problem->state().u.l2_norm())
          << ", another path than the one step " << yes(distance(cut, at_once) > 1e-4)
          << std::endl;
  }

  // The memory of friction on its way to refined meshes: without it nothing would
  // slip at the end of this path, where the body is as it is made but pressed.
  void check_refinement(const std::string &method)
  {
    const Run back(shipped("brick.prm"),
                   brick + Settings{"Contact solver/Method=" + method,
                                    "Material/Poisson ratio=0", moved + there_and_back,
                                    "Time/Steps=1, 2, 3", "Refinement/Adaptive steps=1"});
    const Eigen::VectorXd &lambda = back.problem->state().lambda;
    out() << method << ", refined in every step: certified " << yes(back.converged)
          << ", friction along x = F x pressing to 1e-6 "
          << yes(std::abs(back.summary()["contact"]["force_on_body"][0].get<double>() /
                            (0.3 * lambda.head(lambda.size() / 3).sum()) -
                          1.) < 1e-6)
          << std::endl;
  }

  // A small sphere that a formula moves along the body: nodes far from it face away.
  void check_other_nodes(const std::string &method)
  {
    const Run moves(shipped("brick.prm"),
                    brick + Settings{"Contact solver/Method=" + method, moved + "0; 0; 0",
                                     "Boundary conditions/Obstacle=sphere : 1+2*t; 1.5; "
                                     "-0.0999; 0.1",
                                     "Time/Steps=0.25, 0.5, 1"});
    out() << method << ", others are contact nodes in each step: certified "
          << yes(moves.converged) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Method &method : all_methods())
    if (method.name == "newton" || method.name == "newton multigrid" ||
        method.name == "gauss seidel")
      check(method);
  check_cut();
  for (const std::string method : {"newton", "newton multigrid"})
    {
      check_refinement(method);
      check_other_nodes(method);
    }
}
