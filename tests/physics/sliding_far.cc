// Obstacles whose gaps and normals are taken where body and obstacle come to, 'Sliding =
// far'. A ball pressed on by a force presses alike from wherever it begins, with
// friction, and so does the energy it takes; dragged along by five of its diameters of
// contact it is opposed by F times its force all the way, and a ball that begins there
// without friction exerts the same. A body that its supports move under a fixed ball is
// the body at rest under a ball moved the other way. All methods, elements of degree 2,
// obstacles of triangles, adaptive refinement in a history, restart; energies balance. A
// leaf whose end is lifted by a roller bends as a beam does.

#include "sliding_block.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace stiction;

namespace
{
  std::string ball_at(const double x, const double z)
  {
    return "Boundary conditions/Obstacle=sphere : " + exact(x) + ";10;" + exact(z) +
           ";50";
  }

  double total(const Run &run, const char *what)
  {
    double sum = 0.;
    for (const auto &step : run.summary()["steps"])
      sum += step["energy"][what].get<double>();
    return sum;
  }

  void press_from_afar(const std::string &file)
  {
    const Run near(file, {ball_at(16, 60), force, "Time/Steps=2"});
    for (const double height : {60.01, 75., 300.})
      {
        const Run far(file, {ball_at(16, height), force, "Time/Steps=2"});
        const double work = total(near, "work_obstacles");
        out() << "pressed from " << height - 60. << " away: certified "
              << yes(far.converged) << ", the same forces to 1e-6 "
              << yes(distance(far, near) < 1e-6) << ", work to 1e-6 "
              << yes(std::abs(total(far, "work_obstacles") / work - 1.) < 1e-6)
              << ", no slip but that of near "
              << yes(std::abs(total(far, "dissipated") - total(near, "dissipated")) <
                     1e-6 * work)
              << ", energies balance to 1e-8 " << yes(worst_balance(far) < 1e-8)
              << std::endl;
      }
  }

  // @param settings of the methods and meshes.
  void drag_along(const std::string &file, const std::string &name,
                  const Settings &settings, const std::string &obstacle)
  {
    const Settings all = settings + Settings{obstacle, force, drag + "12*t; 0; 0"};
    const Run run(file, all + Settings{"Time/Steps=6"});
    bool slides = true;
    double work = 0., rubbed = 0.; // after the first step, which presses
    for (const auto &step : run.summary()["steps"])
      {
        const std::array<double, 3> f = step["force_on_body"];
        // it climbs what it pressed in, unevenly by the mesh
        slides = slides && std::abs(-f[0] / f[2] - 0.2) < 0.01;
        if (step["step"] > 1)
          {
            work += step["energy"]["work_obstacles"].get<double>();
            rubbed += step["energy"]["dissipated"].get<double>();
          }
      }
    out() << "dragged, " << name << ": certified " << yes(run.converged)
          << ", slides with F N in all steps " << yes(slides)
          << ", works as much as it rubs to 5 % "
          << yes(std::abs(work / rubbed - 1.) < 0.05) << ", energies balance to 1e-8 "
          << yes(worst_balance(run) < 1e-8) << ", no warning of it "
          << yes(run.summary()["warnings"].dump().find("moved along an obstacle") ==
                 std::string::npos)
          << std::endl;
  }

  // Where it comes to it is as one that begins there.
  void compare_without_friction(const std::string &file)
  {
    const Settings smooth = {"Friction/Law=frictionless", "Friction/Coefficient="};
    const Run here(file, smooth + Settings{ball_at(22.7, 60), force});
    for (const std::string steps : {"1", "3"})
      {
        const Run dragged(file,
                          smooth + Settings{ball_at(10, 80), force, drag + "12.7*t; 0; 0",
                                            "Time/Steps=" + steps});
        out() << "frictionless, there in " << steps << ": certified "
              << yes(dragged.converged) << ", as if it began there to 1e-7 "
              << yes(distance(dragged, here) < 1e-7) << std::endl;
      }
  }

  void move_the_body(const std::string &file)
  {
    const std::string held = "Boundary conditions/Prescribed displacement=bottom : ";
    const Settings steps   = {"Time/Steps=3"};
    const Run body(file, steps + Settings{ball_at(20, 59.9), held + "-8*t; 0; 0"});
    const Run ball(file, steps + Settings{ball_at(20, 59.9), drag + "8*t; 0; 0"});
    const Run little(file, steps + Settings{ball_at(20, 59.9), held + "-8*t; 0; 0",
                                            "Boundary conditions/Sliding=little"});
    out() << "the body is moved under the ball: certified "
          << yes(body.converged && ball.converged) << ", as if the ball were, to 1e-7 "
          << yes(distance(body, ball) < 1e-7) << ", not so where normals remain "
          << yes(distance(little, ball) > 0.1) << ", which a warning says "
          << yes(little.summary()["warnings"].dump().find("'Sliding = far'") !=
                 std::string::npos)
          << std::endl;
  }

  // A hemisphere of triangles.
  std::string stl_ball()
  {
    const int n      = 64;
    std::string text = "solid ball\n";
    const auto point = [&](const int i, const int j) {
      // of the lowest part alone
      const double theta = dealii::numbers::PI * (1. - 0.3 * i / n),
                   phi   = 2. * dealii::numbers::PI * (j % n) / n;
      return "vertex " + exact(12. + 50. * std::sin(theta) * std::cos(phi)) + ' ' +
             exact(10. + 50. * std::sin(theta) * std::sin(phi)) + ' ' +
             exact(60. + 50. * std::cos(theta)) + '\n';
    };
    const auto facet = [&](const std::string &a, const std::string &b,
                           const std::string &c) {
      text += "facet normal 0 0 0\nouter loop\n" + a + b + c + "endloop\nendfacet\n";
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        {
          facet(point(i + 1, j), point(i, j), point(i + 1, j + 1));
          if (i > 0)
            facet(point(i, j), point(i, j + 1), point(i + 1, j + 1));
        }
    return text + "endsolid ball\n";
  }

  void go_on(const std::string &file)
  {
    const Settings all = {ball_at(10, 75), force, drag + "12*t; 0; 0", "Time/End=1"};
    for (const std::string method : {"newton", "newton multigrid"})
      {
        const Settings with = all + Settings{"Contact solver/Method=" + method};
        const Run straight(file, with + Settings{"Time/Steps=0.25, 0.5, 0.75, 1"});
        {
          const Run first(file, with + Settings{"Time/End=0.5", "Time/Steps=0.25, 0.5",
                                                "Time/Checkpoint every=1"});
        }
        const Run then(file, with + Settings{"Time/Steps=0.25, 0.5, 0.75, 1"}, "results");
        out() << "restarted, " << method << ": the same "
              << (is_alone() ? "bits " : "to 1e-10 ")
              << yes(straight.converged && then.converged &&
                     distance(then, straight) <= (is_alone() ? 0. : 1e-10))
              << ", energies balance to 1e-8 " << yes(worst_balance(then) < 1e-8)
              << std::endl;
      }
  }

  // Half a ball that leaves what it was made on, whose nodes then face away, and one that
  // slides down, with a step that is cut before anything is known.
  void change_nodes()
  {
    const Settings half     = {"Geometry/Global refinement=2",
                               "Boundary conditions/Initial gap=0",
                               "Boundary conditions/Sliding=far",
                               "Material/Poisson ratio=0.3",
                               "Friction/Law=coulomb",
                               "Friction/Coefficient=0.2"};
    const std::string moved = "Boundary conditions/Prescribed displacement=flat : ",
                      below = "Boundary conditions/Obstacle=";
    for (const std::string method : {"newton", "newton multigrid"})
      {
        const Settings by = half + Settings{"Contact solver/Method=" + method};
        const Run lifted(
          shipped("half_ball.prm"),
          by + Settings{below + "cylinder : 0;0;-1; 0;1;0; 1", moved + "0; 0; 0.5"});
        const Run slid(shipped("half_ball.prm"),
                       by + Settings{below + "sphere : 0;0;-0.5; 0.5", "Time/Steps=1",
                                     moved + "0.1*t; 0; -0.2*t",
                                     "Time/Smallest step=0.01"});
        const auto &contact = lifted.summary()["contact"];
        out() << "other nodes, " << method << ": lifted off certified "
              << yes(lifted.converged) << ", touches nothing "
              << yes(contact["closed"] == 0) << "; slid down certified "
              << yes(slid.converged) << ", energies balance to 1e-8 "
              << yes(worst_balance(slid) < 1e-8) << std::endl;
      }
  }

  // A beam of the length L with the force P at its end, and H along it on its lower side,
  // goes up there by w = P L³/3EI − H (h/2) L²/2EI. The corner of its end is on the
  // roller first, H = −P tan θ, and where that is under it a beam of that length is bent
  // to the height of the roller.
  void lift_a_leaf()
  {
    const Run run(shipped("latch.prm"),
                  {"Friction/Law=frictionless", "Friction/Coefficient="});
    const double EI = 2000. * 4. / 12., L = 40., R = 3.;
    double of_corner = 0., slope = 0., of_roller = 0.;
    unsigned int n = 0, m = 0;
    for (const auto &step : run.summary()["steps"])
      {
        const double x                = 43. - step["t"].get<double>();
        const std::array<double, 3> f = step["force_on_body"];
        if (x > L && f[2] > 0.)
          {
            const double height = std::sqrt(R * R - (x - L) * (x - L));
            const double P =
              3. * EI * (height - 2.) / std::pow(L, 3) / (1. + 0.75 * f[0] / f[2] / L);
            of_corner = std::max(of_corner, std::abs(f[2] / P - 1.));
            slope     = std::max(slope, std::abs(f[0] / f[2] - (L - x) / height));
            ++n;
          }
        else if (x < L - 0.5)
          {
            of_roller =
              std::max(of_roller, std::abs(f[2] / (3. * EI / std::pow(x, 3)) - 1.));
            ++m;
          }
      }
    out() << "a leaf on a roller: certified " << yes(run.converged)
          << ", force of a beam at its corner to 3 % " << yes(n > 5 && of_corner < 0.03)
          << ", along the normal there " << yes(slope < 0.01)
          << ", and farther on to 3 % " << yes(m > 10 && of_roller < 0.03)
          << ", energies balance to 1e-8 " << yes(worst_balance(run) < 1e-8) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string problem = file("block.prm", block);
  press_from_afar(problem);
  for (const Method &method : all_methods())
    drag_along(problem, method.name, method.settings, ball_at(12, 75));
  if (is_alone())
    drag_along(problem, "degree 2", {"Geometry/Element degree=2"}, ball_at(12, 75));
  drag_along(problem, "graded",
             {"Geometry/Contact refinement=1",
              "Geometry/Contact refinement where=36 - (y - 10)^2"},
             ball_at(12, 75));
  drag_along(problem, "adaptive", {"Refinement/Adaptive steps=1"}, ball_at(12, 75));
  if (is_alone())
    {
      drag_along(problem, "triangles", {},
                 "Boundary conditions/Obstacle=file : " + file("ball.stl", stl_ball()));
      compare_without_friction(problem);
    }
  move_the_body(problem);
  go_on(problem);
  change_nodes();
  if (is_alone())
    lift_a_leaf();
}
