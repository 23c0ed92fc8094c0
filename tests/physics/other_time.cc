// Loads, supports, gaps, obstacles and friction are functions of t. A
// discretization that is taken to another time solves the problem of that time:
// the forces are those of a run that began there, with all kinds of methods, and
// K is neither assembled nor factorised again, even where an obstacle turns its
// normals.

#include "tests.h"

#include <stiction/base/log.h>
#include <stiction/base/phases.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/simulation/discretization.h>

using namespace stiction;

namespace
{
  // At t = 0.4 and then at t = 1, the last one from the forces of the first.
  void go_on(const std::string &name, const Settings &settings)
  {
    const Settings silent = {"Output/Print progress=false",
                             "Boundary conditions/Time=0.4"};
    Parameters parameters;
    parameters.read(shipped("brick.prm"), settings + silent);
    const Body body(parameters.geometry, MPI_COMM_WORLD);
    Log log(MPI_COMM_WORLD);
    Phases phases;
    Discretization discretization;
    auto &[elasticity, surface, solver] = discretization;
    elasticity = std::make_unique<LinearElasticity>(body, parameters.of_body());
    surface    = std::make_unique<ContactSurface>(*elasticity, parameters.of_contact());
    State state;
    const auto solve = [&]() {
      if (!solver)
        solver = ContactSolver::create({parameters, *elasticity, *surface, log, phases});
      solver->solve(state, [](const ContactStep &) {});
      return Certificate(*elasticity, *surface, state)
        .converged(parameters.contact_solver.tolerance);
    };
    const bool is_first_certified     = solve();
    const Eigen::VectorXd first       = state.lambda;
    const ContactSolver *const before = solver.get();
    discretization.set_time(parameters.of_contact(), 1., {});
    const bool is_kept      = solver.get() == before && before != nullptr;
    const bool is_certified = solve();

    const Run anew(shipped("brick.prm"),
                   settings + Settings{"Boundary conditions/Time=1"});
    const Eigen::VectorXd &expected = anew.problem->state().lambda;
    out() << name << ": certified " << yes(is_first_certified && is_certified)
          << ", the forces of a run that begins there to 1e-7 "
          << yes((state.lambda - expected).norm() < 1e-7 * expected.norm())
          << ", others than before "
          << yes((first - expected).norm() > 0.1 * expected.norm())
          << ", the solver is kept " << yes(is_kept) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Settings brick = {
    "Geometry/Table 1 level=0",
    "Geometry/Lengths=4,3,1",
    "Geometry/Subdivisions=4,3,1",
    "Geometry/Global refinement=1",
    "Contact solver/Tolerance=1e-9",
    "Boundary conditions/Prescribed displacement=front : 1e-4*t; 0; -2e-4*t",
    "Boundary conditions/Traction=top : 1e7*t; 0; -1e8*t^2",
    "Boundary conditions/Gravity=0; 0; -1e4*t",
    "Material/Densities=0 : 7800",
    "Boundary conditions/Initial gap=1e-4*t*x",
    "Boundary conditions/Obstacle displacement=0; 1e-4*t; 2e-4*t",
    "Friction/Coefficient=0.2+0.2*t"};
  for (const Method &method : all_methods())
    go_on(method.name, brick + method.settings);
  for (const std::string method : {"newton", "newton multigrid"})
    {
      const Settings by = {"Contact solver/Method=" + method};
      go_on("given friction, " + method,
            brick + by +
              Settings{"Friction/Law=given", "Friction/Slip stress=1e7*(1+t)"});
      go_on("pressed, " + method,
            brick + by +
              Settings{"Boundary conditions/Obstacle force=0; 0; 1e9*t",
                       "Boundary conditions/Obstacle displacement=0; 0; 0"});
      go_on("an obstacle that turns, " + method,
            brick + by +
              Settings{"Boundary conditions/Obstacle=formula : z + 0.05*t*x",
                       "Boundary conditions/Initial gap=0"});
    }
}
