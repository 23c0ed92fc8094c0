// Where Newton steps come no closer on a mesh with 'Contact refinement', coarser meshes
// give them another start: near the answer, on the unknowns of the mesh itself.

#include "tests.h"

#include <stiction/base/log.h>
#include <stiction/base/phases.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/certified_solve.h>
#include <stiction/simulation/solvers/coarser_meshes.h>

#include <string>

using namespace stiction;

namespace
{
  // How many Newton steps on the mesh itself it takes from here to the answer of the run.
  unsigned int solve_from(const std::string &name, State state, const Run &run)
  {
    const ContactProblem &problem = *run.problem;
    NewtonMultigrid newton(problem.elasticity(), problem.contact_surface(),
                           run.parameters.is_matrix_free());
    const SolveStatus status = newton.solve(state, 1e-8, 100, [](const ContactStep &) {});
    const auto &lambda       = problem.state().lambda;
    out() << name << ": solved " << yes(status.converged) << ", "
          << "same answer " << yes((state.lambda - lambda).norm() < 1e-6 * lambda.norm())
          << std::endl;
    return newton.statistics().back().newton_steps;
  }

  void compare(const std::string &name, const Settings &settings)
  {
    const Run run(
      shipped("several_bodies/two_spheres.prm"),
      Settings{"Contact solver/Method=newton multigrid", "Output/Write solution=false"} +
        settings);
    const ContactProblem &problem = *run.problem;
    Log log(MPI_COMM_WORLD);
    Phases phases;
    const ContactSolver::Setting setting{run.parameters, problem.elasticity(),
                                         problem.contact_surface(), log, phases};
    out() << name << ": there are coarser meshes "
          << yes(CoarserMeshes::are_there(setting)) << std::endl;
    CoarserMeshes meshes(setting);
    unsigned int n_steps = 0;
    bool is_counted_on   = true;
    ContactStep last;
    const State start  = meshes.find({}, last, [&](const ContactStep &step) {
      is_counted_on = is_counted_on && step.step == ++n_steps;
    });
    const auto &lambda = problem.state().lambda;
    out() << "start within half of the answer's forces "
          << yes((start.lambda - lambda).norm() < 0.5 * lambda.norm()) << ", levels "
          << meshes.statistics().levels.size() << ", steps are counted on "
          << yes(is_counted_on) << std::endl;
    const unsigned int from_there   = solve_from("from there", start, run);
    const unsigned int from_nothing = solve_from("from nothing", {}, run);
    out() << "from there no more steps " << yes(from_there <= from_nothing) << std::endl;
  }
  // A strip on its ground, lifted at an end: from nothing Newton steps come no closer.
  void lift()
  {
    const Settings strip = {
      "Geometry/Lengths=40, 2, 0.5",
      "Geometry/Subdivisions=80, 2, 1",
      "Geometry/Contact refinement=1",
      "Geometry/Contact refinement where=20 - x",
      "Material/Young's modulus=2.1e5",
      "Material/Poisson ratio=0.3",
      "Boundary conditions/Prescribed displacement=right : 0; 0; 0.5",
      "Boundary conditions/Traction=top : 0; 0; -0.2",
      "Boundary conditions/Contact boundary=bottom",
      "Boundary conditions/Obstacle=foundation",
      "Friction/Law=coulomb",
      "Friction/Coefficient=0.3",
      "Contact solver/Tolerance=1e-8",
      "Output/Write solution=false"};
    const Run run("", strip + Settings{"Contact solver/Method=newton multigrid"});
    const Run dual("", strip + Settings{"Contact solver/Method=newton"});
    const auto &solver = run.summary()["solver"];
    out() << "strip: certified " << yes(run.converged) << ", on coarser meshes too "
          << yes(solver["coarse_krylov_iterations"].get<int>() > 0 &&
                 solver["levels"].size() > 1)
          << ", newton finds the same " << yes(distance(run, dual) < 1e-5) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  compare("degree 1", {});
  compare("degree 2", {"Geometry/Global refinement=2", "Geometry/Element degree=2",
                       "Geometry/Contact refinement=1"});
  lift();
}
