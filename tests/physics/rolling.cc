// Obstacles that turn while they slide far. A roller that rolls along an incompressible
// block with a creep is opposed as F. W. Carter has it (On the action of a locomotive
// driving wheel, 1926): by Q = F N (1 − (1 − ξ R/(F a))²), a being half the width of
// contact. A ball that is dragged and spins across is opposed along the slip of its
// surface, in all methods; a body that its supports move under it is the body at rest
// under a ball that moves the other way, adaptive and restarted histories keep how far it
// had turned, and one that turns in its place is as with 'Sliding = little'.

#include "sliding_block.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace stiction;

namespace
{
  std::array<double, 3> last_force(const Run &run)
  {
    return run.summary()["steps"].back()["force_on_body"];
  }

  // A strip in plane strain, on which a roller of radius 2 rolls for twelve times a.
  void compare_with_carter()
  {
    const double E = 1000., nu = 0.499, F = 0.3, R = 2., width = 0.25, P = 5.,
                 creep = 0.008;
    std::string times  = "1";
    for (unsigned int i = 1; i <= 40; ++i)
      times += ", " + exact(1. + i / 40.);
    const std::string strip = file(
      "strip.prm", "subsection Geometry\n"
                   "  set Lengths = 4, 0.25, 2\n"
                   "  set Subdivisions = 16, 1, 8\n"
                   "  set Contact refinement = 2\n"
                   "  set Contact refinement where = 1.6 - abs(x - 2)\n"
                   "end\n"
                   "subsection Material\n"
                   "  set Young's modulus = 1000\n"
                   "  set Poisson ratio = 0.499\n"
                   "end\n"
                   "subsection Boundary conditions\n"
                   "  set Prescribed displacement = bottom : 0; 0; 0 |"
                   " front : free; 0; free | back : free; 0; free\n"
                   "  set Contact boundary = top\n"
                   "  set Obstacle = cylinder : 0.8; 0; 4; 0; 1; 0; 2\n"
                   "  set Obstacle displacement = 2.4*max(t - 1, 0); 0; 0\n"
                   "  set Obstacle rotation = 0.8; 0; 4; 0; 1; 0; 1.2*max(t - 1, 0)*" +
                     exact(1. + creep) +
                     "\n"
                     "  set Obstacle force = 0; 0; -5*min(t, 1)\n"
                     "  set Sliding = far\n"
                     "end\n"
                     "subsection Friction\n"
                     "  set Law = coulomb\n"
                     "  set Coefficient = 0.3\n"
                     "end\n"
                     "subsection Time\n"
                     "  set End = 2\n"
                     "  set Steps = " +
                     times + "\nend\n");
    const Run run(
      strip, {"Contact solver/Method=newton multigrid", "Contact solver/Tolerance=1e-9"});
    const double a     = std::sqrt(4. * P / width * R * (1. - nu * nu) /
                                   (dealii::numbers::PI * E)),
                 stuck = 1. - creep * R / (F * a), Q = F * P * (1. - stuck * stuck);
    out() << "Carter: certified " << yes(run.converged)
          << ", drives the strip back with Q to 6 % "
          << yes(std::abs(-last_force(run)[0] / Q - 1.) < 0.06)
          << ", energies balance to 1e-8 " << yes(worst_balance(run) < 1e-8) << std::endl;
  }

  const std::string ball = "Boundary conditions/Obstacle=sphere : 12; 10; 60; 50";

  // About the way of the ball, so that its lowest point moves across by 50 times the
  // angle.
  std::string spin(const std::string &angle)
  {
    return "Boundary conditions/Obstacle rotation=12; 10; 60; 1; 0; 0; " + angle;
  }

  void drag_and_spin(const std::string &file, const std::string &name,
                     const Settings &settings)
  {
    const Run run(file, settings + Settings{ball, force, drag + "12*t; 0; 0",
                                            spin("0.12*t"), "Time/Steps=6"});
    bool slides = true;
    double work = 0., rubbed = 0.; // after the first step, which presses
    for (const auto &step : run.summary()["steps"])
      {
        const std::array<double, 3> f = step["force_on_body"];
        if (step["step"] == 1)
          continue;
        slides = slides && std::abs(f[1] / f[0] - 0.5) < 0.05 &&
                 std::abs(-std::hypot(f[0], f[1]) / f[2] - 0.2) < 0.01;
        work += step["energy"]["work_obstacles"].get<double>();
        rubbed += step["energy"]["dissipated"].get<double>();
      }
    out() << "dragged and spun, " << name << ": certified " << yes(run.converged)
          << ", slides with F N along the slip of its surface " << yes(slides)
          << ", works as much as it rubs to 5 % "
          << yes(std::abs(work / rubbed - 1.) < 0.05) << ", energies balance to 1e-8 "
          << yes(worst_balance(run) < 1e-8) << std::endl;
  }

  void move_the_body(const std::string &file)
  {
    const Settings both = {"Boundary conditions/Obstacle=sphere : 12; 10; 59.9; 50",
                           spin("0.1*t"), "Time/Steps=3"};
    const Run body(
      file,
      both + Settings{"Boundary conditions/Prescribed displacement=bottom : -8*t; 0; 0"});
    const Run ball(file, both + Settings{drag + "8*t; 0; 0"});
    out() << "the body is moved under a ball that spins: certified "
          << yes(body.converged && ball.converged) << ", as if the ball were, to 1e-7 "
          << yes(distance(body, ball) < 1e-7) << std::endl;
  }

  void go_on(const std::string &file)
  {
    const Settings all = {ball, force, drag + "12*t; 0; 0", spin("0.12*t"), "Time/End=1"};
    const Run straight(file, all + Settings{"Time/Steps=0.25, 0.5, 0.75, 1"});
    {
      const Run first(file, all + Settings{"Time/End=0.5", "Time/Steps=0.25, 0.5",
                                           "Time/Checkpoint every=1"});
    }
    const Run then(file, all + Settings{"Time/Steps=0.25, 0.5, 0.75, 1"}, "results");
    out() << "restarted: the same " << (is_alone() ? "bits " : "to 1e-10 ")
          << yes(straight.converged && then.converged &&
                 distance(then, straight) <= (is_alone() ? 0. : 1e-10))
          << std::endl;
  }

  void turn_in_place(const std::string &file)
  {
    const Settings both = {ball, force, spin("2e-3*t"), "Time/Steps=4"};
    const Run far(file, both);
    const Run little(file, both + Settings{"Boundary conditions/Sliding=little"});
    out() << "turned in its place: certified " << yes(far.converged && little.converged)
          << ", slips in part " << yes(far.summary()["contact"]["slip"] > 0)
          << ", as with little sliding to 1 % " << yes(distance(far, little) < 0.01)
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (is_alone())
    compare_with_carter();
  const std::string problem = file("block.prm", block);
  for (const Method &method : all_methods())
    drag_and_spin(problem, method.name, method.settings);
  drag_and_spin(problem, "adaptive", {"Refinement/Adaptive steps=1"});
  move_the_body(problem);
  go_on(problem);
  turn_in_place(problem);
}
