// Obstacles that are displaced, and that are pressed on with a force. Exact: a
// column under pressure from a plane. On the reference brick: to displace the
// foundation is to displace the supports; what a force reaches, the distance it
// found reaches as a prescribed displacement; energies balance. All kinds of
// methods; an oblique force; two obstacles on one body; on graded and
// quadratic meshes; a sphere that is drawn along.

#include "tests.h"

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  const Eigen::VectorXd &lambda(const Run &run) { return run.problem->state().lambda; }

  nlohmann::json boundary(const Run &run, const unsigned int number = 0)
  {
    return run.summary()["contact"]["boundaries"][number];
  }

  // Relative to the work of the loads and of the obstacles.
  double imbalance_of_energy(const Run &run)
  {
    const auto &energy  = run.summary()["energy"];
    const double strain = energy["strain"], work = energy["load_work"],
                 friction  = energy["friction_dissipation"];
    const double obstacles = -lambda(run).dot(
      run.problem->contact_surface().motion().offset(run.problem->state().distances));
    return std::abs(2. * strain + friction - work - obstacles) /
           std::max(std::abs(work), std::abs(obstacles));
  }

  // P = 3000 N on 0.5 m², E = 1e6 Pa, height 2 m: 0.012 m beyond the gap.
  void press_column()
  {
    const Settings column = {
      "Geometry/Table 1 level=0",
      "Geometry/Lengths=1,0.5,2",
      "Geometry/Subdivisions=2,1,2",
      "Geometry/Global refinement=1",
      "Material/Young's modulus=1e6",
      "Material/Poisson ratio=0.3",
      "Boundary conditions/Prescribed displacement=top : free; free; 0 | left "
      ": 0; free; free | front : free; 0; free",
      "Boundary conditions/Traction=",
      "Boundary conditions/Initial gap=0.001",
      "Boundary conditions/Obstacle force=0; 0; 1500*t",
      "Boundary conditions/Time=2",
      "Friction/Law=frictionless",
      "Contact solver/Tolerance=1e-9"};
    const std::vector<Settings> bodies = {
      {},
      {"Geometry/Element degree=2"},
      {"Geometry/Contact refinement=1"},
      {"Refinement/Adaptive steps=1"},
      {"Boundary conditions/Obstacle=plane : 0; 0; 0; 0; 0; 1"}};
    bool are_certified = true;
    double error       = 0.;
    const auto check   = [&](const Settings &settings) {
      const Run run(shipped("brick.prm"), column + settings);
      are_certified       = are_certified && run.converged;
      const auto &surface = run.problem->contact_surface();
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        error = std::max(error, std::abs(lambda(run)(i) / surface.areas()(i) / 6e3 - 1.));
      error = std::max(
          error,
          std::abs(boundary(run)["obstacle_displacement"][2].get<double>() / 0.013 - 1.));
      error = std::max(error, imbalance_of_energy(run));
    };
    for (const Method &method : all_methods())
      check(method.settings);
    for (const Settings &body : bodies)
      {
        check(body);
        check(body + Settings{"Contact solver/Method=newton multigrid"});
      }
    out() << "column: certified " << yes(are_certified)
          << ", pressure, distance and energies to 1e-8 " << yes(error < 1e-8)
          << std::endl;
  }

  const Settings brick = {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                          "Geometry/Subdivisions=4,3,1", "Geometry/Global refinement=1",
                          "Contact solver/Tolerance=1e-9"};

  // The whole world moved by U changes no force.
  void move_the_foundation()
  {
    const std::string U = "2e-4; -1e-4; 1e-4", minus_U = "-2e-4; 1e-4; -1e-4";
    for (const std::string law : {"given", "coulomb"})
      for (const std::string method : {"gauss seidel", "newton multigrid"})
        {
          const Settings all =
            brick + Settings{"Friction/Law=" + law, "Friction/Slip stress=1.5e7",
                             "Contact solver/Method=" + method};
          const Run foundation(shipped("brick.prm"),
                               all + Settings{"Boundary conditions/Obstacle "
                                              "displacement=" +
                                              U});
          const Run supports(shipped("brick.prm"),
                             all + Settings{"Boundary conditions/Prescribed "
                                            "displacement=2 : " +
                                            minus_U});
          const Run neither(shipped("brick.prm"), all);
          out() << law << ", " << method << ", moved foundation: certified "
                << yes(foundation.converged) << ", the forces of moved supports to 1e-6 "
                << yes(distance(foundation, supports) < 1e-6) << ", others than at rest "
                << yes(distance(foundation, neither) > 0.1)
                << ", energies balance to 1e-8 "
                << yes(imbalance_of_energy(foundation) < 1e-8) << std::endl;
        }
  }

  // A body of one layer of cells, of which every contact node is held along x,
  // and a plane that leans that way: all that the plane sees of supports that
  // are moved along x is that it is moved the other way.
  void move_held_nodes()
  {
    const auto press = [](const double u, const double obstacle) {
      const std::string along_x = exact(u) + "; free; free";
      return Run(shipped("brick.prm"),
                 {"Geometry/Table 1 level=0", "Geometry/Lengths=0.25,3,1",
                  "Geometry/Subdivisions=1,6,2", "Geometry/Global refinement=0",
                  "Boundary conditions/Prescribed displacement=front : free; "
                  "0; 0 | left : " +
                    along_x + " | right : " + along_x,
                  "Boundary conditions/Traction=top : 0; 0; -1e8",
                  "Boundary conditions/Obstacle=plane : 0; 0; -1e-3; 0.3; 0; 1",
                  "Boundary conditions/Obstacle displacement=" + three(obstacle, 0., 0.),
                  "Contact solver/Tolerance=1e-9"});
    };
    const Run supports = press(2e-3, 0.), plane = press(0., -2e-3),
              neither = press(0., 0.);
    out() << "held along a part of the normal: certified "
          << yes(supports.converged && plane.converged)
          << ", moved supports are a moved plane to 1e-7 "
          << yes(distance(supports, plane) < 1e-7) << ", and not one at rest "
          << yes(distance(supports, neither) > 0.01) << std::endl;
  }

  // Up and a little sideways, with all three states.
  void press_obliquely()
  {
    const std::string entry = "Boundary conditions/Obstacle force=";
    const Settings all      = brick + Settings{entry + "1e7; 0; 3e8"};
    const double P          = std::hypot(1e7, 3e8);
    const Run first(shipped("brick.prm"), all);
    const auto along_force = [&](const nlohmann::json &v) {
      return (1e7 * v[0].get<double>() + 3e8 * v[2].get<double>()) / P;
    };
    const auto u = boundary(first)["obstacle_displacement"];
    const Run displaced(shipped("brick.prm"),
                        brick + Settings{"Boundary conditions/Obstacle "
                                         "displacement=" +
                                         exact(u[0]) + "; 0; " + exact(u[2])});
    const auto &contact = first.summary()["contact"];
    out() << "oblique: certified " << yes(first.converged)
          << ", force along its direction to 1e-8 "
          << yes(std::abs(along_force(boundary(first)["force_on_body"]) / P - 1.) < 1e-8)
          << ", moved along it "
          << yes(std::abs(u[0].get<double>() * 3e8 - u[2].get<double>() * 1e7) < 1e-8 * P)
          << ", the forces of that displacement to 1e-6 "
          << yes(distance(first, displaced) < 1e-6) << ", nodes slip and stick "
          << yes(contact["slip"] > 0 && contact["stick"] > 0)
          << ", energies balance to 1e-8 " << yes(imbalance_of_energy(first) < 1e-8)
          << std::endl;

    bool are_certified = true;
    double largest     = 0.;
    for (const Method &method : all_methods())
      {
        const Run run(shipped("brick.prm"), all + method.settings);
        are_certified = are_certified && run.converged;
        largest       = std::max(largest, distance(run, first));
      }
    out() << "all methods: certified " << yes(are_certified)
          << ", the same forces to 1e-6 " << yes(largest < 1e-6) << std::endl;
  }

  // One from below and one from above, which are felt by each other.
  void press_from_two_sides()
  {
    const Settings two =
      brick + Settings{
                "Boundary conditions/Traction=",
                "Boundary conditions/Contact boundary=bottom | top",
                "Boundary conditions/Obstacle=foundation | sphere : 2; 2; 11; 10",
              };
    for (const double below : {3e7, 3e5, 2e2})
      for (const std::string method :
           {"newton", "newton multigrid", "gauss seidel", "mpgp", "admm"})
        {
          if (method == "admm" && below < 1e3)
            continue; // its steps do not see what is that small
          const Run run(shipped("brick.prm"),
                        two + Settings{"Contact solver/Method=" + method,
                                       "Contact solver/Maximum iterations=10000",
                                       "Boundary conditions/Obstacle force=" +
                                         three(0., 0., below) + " | 0; 0; -2e7"});
          const auto force = [&](const unsigned int b) {
            return boundary(run, b)["force_on_body"][2].get<double>();
          };
          out() << "two obstacles, " << below << " N and 2e7 N, " << method
                << ": certified " << yes(run.converged) << ", forces to 1e-7 "
                << yes(std::abs(force(0) / below - 1.) < 1e-7 &&
                       std::abs(force(1) / -2e7 - 1.) < 1e-7)
                << std::endl;
        }
  }

  // A force that is small beside the loads of the body, and a steep obstacle that no
  // node of the coarse levels faces.
  void press_lightly()
  {
    const std::string entry = "Boundary conditions/Obstacle force=0; 0; ";
    for (const std::string method :
         {"newton", "newton multigrid", "gauss seidel", "mpgp"})
      {
        const Run run(shipped("brick.prm"),
                      {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                       "Geometry/Subdivisions=4,3,1", "Geometry/Global refinement=1",
                       "Contact solver/Method=" + method, entry + "1"});
        const auto u = boundary(run)["obstacle_displacement"][2].get<double>();
        out() << "1 N beside 6e8 N, " << method << ": certified " << yes(run.converged)
              << ", at its place to 1e-4 " << yes(std::abs(u / -0.03539 - 1.) < 1e-4)
              << std::endl;
      }

    double forces[2] = {};
    bool certified   = true;
    unsigned int k   = 0;
    for (const std::string method : {"newton", "newton multigrid"})
      {
        const Run run(shipped("sphere.prm"),
                      {"Geometry/Global refinement=3", "Contact solver/Method=" + method,
                       "Boundary conditions/Obstacle=formula : 0.5 + 50*((x - 0.37)^2 "
                       "+ (y - 0.41)^2) - z",
                       entry + "-1e6"});
        certified   = certified && run.converged;
        forces[k++] = run.summary()["contact"]["max_pressure"].get<double>();
      }
    out() << "a steep obstacle: certified " << yes(certified)
          << ", pressures agree to 1e-6 "
          << yes(std::abs(forces[1] / forces[0] - 1.) < 1e-6) << std::endl;
  }

  // Amontons' law for a sphere that slides, and less for one that does not.
  void slide()
  {
    const auto ratio = [](const Run &run) {
      const auto force = boundary(run)["force_on_body"];
      return -force[0].get<double>() / force[2].get<double>() / 0.3;
    };
    const auto draw = [](const std::string &u) {
      return Run(shipped("sliding_sphere.prm"),
                 {"Boundary conditions/Obstacle displacement=" + u + "; 0; 0",
                  "Geometry/Global refinement=1"});
    };
    const Run little = draw("0.002"), far = draw("0.03");
    out() << "sliding sphere: certified " << yes(little.converged && far.converged)
          << ", pressed by its force "
          << yes(std::abs(boundary(far)["force_on_body"][2].get<double>() / -3077. - 1.) <
                 1e-6)
          << ", slips and sticks "
          << yes(little.summary()["contact"]["slip"] > 0 &&
                 little.summary()["contact"]["stick"] > 0)
          << ", with less than friction could carry " << yes(ratio(little) < 0.8)
          << ", slides as a whole " << yes(far.summary()["contact"]["stick"] == 0)
          << ", with what friction carries to 1e-3 "
          << yes(std::abs(ratio(far) - 1.) < 1e-3) << std::endl;
  }

  // Where there is no load, a little overlap is all there is: no tolerance is
  // too loose to see it.
  void overlap_a_little()
  {
    const auto force = [](const std::string &method, const std::string &tolerance) {
      const Run run(shipped("hertz.prm"),
                    {"Boundary conditions/Obstacle force=0; 0; 0",
                     "Boundary conditions/Obstacle displacement=0; 0; -1e-4",
                     "Geometry/Global refinement=1", "Contact solver/Method=" + method,
                     "Contact solver/Tolerance=" + tolerance});
      return run.converged ? run.summary()["contact"]["normal_force"].get<double>() : -1.;
    };
    const double exact = force("newton", "1e-10");
    bool is_seen       = exact > 0.;
    for (const std::string method :
         {"newton", "gauss seidel", "mpgp", "newton multigrid"})
      is_seen = is_seen && std::abs(force(method, "1e-2") / exact - 1.) < 1e-2;
    out() << "a little overlap and no load: seen at a tolerance of 1e-2 " << yes(is_seen)
          << std::endl;
  }

  // A force that the body cannot take within its size.
  void press_too_hard()
  {
    const Run run(shipped("brick.prm"),
                  brick + Settings{"Boundary conditions/Obstacle force="
                                   "0; 0; 1e13"});
    out() << "more than the body can take: not converged " << yes(!run.converged)
          << ", says why "
          << yes(run.problem->status().reason.find("Obstacle force") != std::string::npos)
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  press_column();
  move_the_foundation();
  move_held_nodes();
  press_obliquely();
  press_from_two_sides();
  press_lightly();
  slide();
  overlap_a_little();

  press_too_hard();
}
