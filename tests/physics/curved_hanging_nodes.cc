// Locally refined bodies with curved boundaries: a hanging node lies where its
// displacement comes from, so rigid rotations do not strain the body and moments
// balance; nodes that do not hang lie on the ball. With elements of both degrees,
// from a file of second order too, on any number of ranks, and in a run that goes
// on from a checkpoint.

#include "second_order_file.h"
#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/coarse_mesh.h>
#include <stiction/elasticity/mesh/geometry_parameters.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  const Settings coarse = {"Geometry/Global refinement=1", "Output/Write solution=false"};
  const Settings from_file = {"Geometry/Type=file", "Geometry/Mesh file=curved_ball.msh",
                              "Geometry/Global refinement=0"};
  const Settings once      = {"Geometry/Contact refinement=1",
                              "Geometry/Contact refinement where=0.4 - z"};
  const Settings twice     = {"Geometry/Contact refinement=2",
                              "Geometry/Contact refinement where=0.4 - z"};
  const Settings adapted   = {"Refinement/Adaptive steps=2"};
  const Settings quadratic = {"Geometry/Element degree=2"};

  Run solve(const Settings &settings)
  {
    return Run(shipped("half_ball.prm"), coarse + settings);
  }

  // How far contact nodes are from the unit sphere around (0, 0, 1).
  double off_the_ball(const Run &run)
  {
    double distance = 0.;
    for (const ContactNode &node : run.problem->contact_surface().nodes())
      distance = std::max(
        distance, std::abs(node.position.distance(dealii::Point<3>(0., 0., 1.)) - 1.));
    return distance;
  }

  void check(const std::string &name, const Settings &settings)
  {
    const Run run          = solve(settings);
    const auto &summary    = run.summary();
    const auto &components = summary["contact"]["force_on_body"];
    out() << name << ": " << summary["problem"]["dofs"] << " unknowns, hanging nodes "
          << yes(run.problem->elasticity().body().n_hanging_nodes() > 0) << ", certified "
          << yes(run.converged) << ", moments balance to 1e-8 "
          << yes(run.problem->certificate().body_figures().moment_balance < 1e-8)
          << ", contact nodes are on the ball to 1e-12 " << yes(off_the_ball(run) < 1e-12)
          << ", force over 1e8 N " << components[2].get<double>() / 1e8 << std::endl;
  }

  // The second step cuts cells of a mesh that came of a checkpoint.
  void check_restart()
  {
    const Settings steps =
      adapted + Settings{"Refinement/Adaptive steps=1", "Contact solver/Method=newton",
                         "Boundary conditions/Prescribed displacement"
                         "=flat : 2e-3*t; 0; -2e-2"};
    const Run straight = solve(steps + Settings{"Time/Steps=1, 2"});
    const Run first = solve(steps + Settings{"Time/Steps=1", "Time/Checkpoint every=1"});
    const Run then(shipped("half_ball.prm"), coarse + steps + Settings{"Time/Steps=1, 2"},
                   "results");
    out() << "from a checkpoint: certified " << yes(straight.converged && then.converged)
          << ", the same forces to 1e-8 " << yes(distance(then, straight) < 1e-8)
          << std::endl;
  }

  // In a rigid cavity all cells are cut in the end, and none hangs any more.
  void check_uniform_again()
  {
    const Run run =
      solve(quadratic +
            Settings{"Geometry/Type=generator", "Geometry/Generator=quarter_hyper_shell",
                     "Geometry/Generator arguments=0,0,0 : 0.93 : 1 : 0 : true",
                     "Geometry/Global refinement=0", "Refinement/Fraction=0.3",
                     "Boundary conditions/Contact boundary=0",
                     "Boundary conditions/Initial gap=0", "Refinement/Adaptive steps=2",
                     "Boundary conditions/Prescribed displacement=2 : 0; free; free | "
                     "3 : free; 0; free | 4 : free; free; 0.004",
                     "Boundary conditions/Obstacle=sphere : 0; 0; 0; 0.935"});
    const auto &body = run.problem->elasticity().body();
    out() << "uniform again: certified " << yes(run.converged) << ", nothing hangs "
          << yes(body.n_hanging_nodes() == 0) << ", refined "
          << yes(body.triangulation().n_global_levels() > 1) << std::endl;
  }

  // The faces of the ball from the file are biquadratic, off by 1e-3.
  void check_file(const std::string &name, const Settings &settings)
  {
    const Run run = solve(from_file + settings);
    out() << name << ": certified " << yes(run.converged) << ", moments balance to 1e-8 "
          << yes(run.problem->certificate().body_figures().moment_balance < 1e-8)
          << ", contact nodes are within 2e-3 of the ball "
          << yes(off_the_ball(run) < 2e-3) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check("refined once", once);
  check("refined twice", twice);
  check("adapted", adapted);
  check("quadratic, refined twice", quadratic + twice);
  check_restart();
  check_uniform_again();

  GeometryParameters geometry;
  geometry.type              = "half ball";
  geometry.radius            = 1.;
  geometry.element_degree    = 2;
  geometry.global_refinement = 1;
  const Body ball(geometry, MPI_COMM_SELF);
  SecondOrderFile(ball.triangulation(), {{"curved", 0}, {"flat", 1}}, ball.mapping())
    .write("curved_ball.msh", 27);
  check_file("from a file", once);
  check_file("from a file, adapted", adapted);
}
