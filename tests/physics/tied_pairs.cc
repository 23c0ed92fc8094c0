// Tied pairs: two bodies that are one. Exact: constant stress of any kind across meshes
// that do not match, plane and tilted, with hanging nodes, of degree 2, with supports and
// without; matching halves as the whole brick, on a foundation with friction; a shell in
// two layers that suction holds off one another; load steps as one step. A body hangs by
// a tie alone, and where nothing holds both the motion is named.

#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include "how_it_ends.h"
#include "several_bodies.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  // What all problems are solved with, beside their own settings.
  Settings method;

  Run solve(const std::string &prm, const Settings &settings = {})
  {
    return Run(prm, method + settings);
  }

  const std::string tied = section("Friction", {"Law = tied"});

  std::string tolerance(const std::string &value)
  {
    return section("Contact solver", {"Tolerance = " + value});
  }

  // The largest relative difference of the tractions on the slaves from t, N/m², or from
  // -t.
  double error_of_traction(const Run &run, const Eigen::Vector3d &t)
  {
    const auto &surface = run.problem->contact_surface();
    const Eigen::VectorXd forces =
      surface.B().force_to_cartesian(run.problem->state().lambda);
    double errors[2] = {0., 0.};
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      for (const int sign : {0, 1})
        errors[sign] = std::max(
          errors[sign],
          (at_node(forces, i) / surface.areas()(i) + (sign == 0 ? 1. : -1.) * t).norm());
    return std::min(errors[0], errors[1]) / t.norm();
  }

  void check_traction(const std::string &what, const std::string &prm,
                      const Eigen::Vector3d &t, const Settings &settings)
  {
    const Run run = solve(prm, settings);
    out() << what << ": certified alone " << yes(certified_alone(run))
          << ", traction to 1e-8 " << yes(error_of_traction(run, t) < 1e-8) << std::endl;
  }

  // Two bricks side by side under tension along x and shear in the plane of x and z,
  // which nothing else holds.
  std::string bar()
  {
    return brick("left", "1,1,1", "3,3,3", "0;0;0") +
           brick("right", "2,1,1", "5,4,4", "1;0;0") +
           section(
             "Boundary conditions",
             {"Traction = left.left : -10; 0; -3 | right.right : 10; 0; 3 | "
              "left.bottom : -3; 0; 0 | right.bottom : -3; 0; 0 | left.top : 3; 0; 0 "
              "| right.top : 3; 0; 0",
              "Contact boundary = left.right", "Obstacle = boundary : right.left"}) +
           tied + tolerance("1e-10");
  }

  // The same under tension along its turned axis, the direction of which it returns.
  Eigen::Vector3d tilted_bar(std::string &prm)
  {
    const Eigen::Vector3d axis = Eigen::Vector3d(1., 2., 0.5).normalized();
    const double pi            = std::acos(-1.);
    const Eigen::Vector3d x = Eigen::AngleAxisd(pi / 6., axis) * Eigen::Vector3d::UnitX();
    const std::string turn  = "0;0;0; 1;2;0.5; 30";
    prm                     = brick("left", "1,1,1", "3,3,3", "0;0;0", turn) +
          brick("right", "2,1,1", "5,4,4", three(x(0), x(1), x(2)), turn) +
          section("Boundary conditions",
                  {"Pressure = left.left : -10 | right.right : -10",
                   "Contact boundary = left.right", "Obstacle = boundary : right.left"}) +
          tied + tolerance("1e-10");
    return x;
  }

  void try_all_methods()
  {
    for (const Method &each : all_methods())
      if (each.solves_given && each.name.find("amg") == std::string::npos)
        check_traction(each.name, file("bar.prm", bar()), {10., 0., 3.}, each.settings);
  }

  void patch_test()
  {
    std::string tilted;
    const Eigen::Vector3d tension = 10. * tilted_bar(tilted);
    check_traction("tilted", file("tilted.prm", tilted), tension, {});
    const Eigen::Vector3d t(10., 0., 3.);
    const std::string prm = file("bar.prm", bar());
    for (const std::string side : {"boundary", "obstacle"})
      {
        const Settings slave = {"Boundary conditions/Slave side=" + side};
        check_traction("plane, " + side, prm, t, slave);
        check_traction("degree 2, " + side, prm, t,
                       slave + Settings{"Geometry/Element degree=2"});
        check_traction("hanging nodes, " + side, prm, t,
                       slave + Settings{"Geometry/Contact refinement=1",
                                        "Geometry/Contact refinement where=0.5-z"});
        check_traction("refined, " + side, prm, t,
                       slave + Settings{"Body right/Refinement=1"});
      }
  }

  // A brick that is pressed and dragged along a foundation, in one piece or cut between
  // its cells.
  std::string dragged(const bool is_cut)
  {
    const std::string top = is_cut ? "upper" : "brick";
    return (is_cut ? brick("lower", "2,1,0.5", "4,3,2", "0;0;0") +
                       brick("upper", "2,1,0.5", "4,3,2", "0;0;0.5")
                   : brick("brick", "2,1,1", "4,3,4", "0;0;0")) +
           section("Boundary conditions",
                   {"Prescribed displacement = " + top + ".top : 0.002 * t; 0; -0.01"}) +
           section("Contact pair floor",
                   {"Boundary = " + std::string(is_cut ? "lower" : "brick") + ".bottom",
                    "Obstacle = foundation", "Initial gap = 0.004 * x", "Law = coulomb",
                    "Coefficient = 0.3"}) +
           (is_cut ? section("Contact pair joint",
                             {"Boundary = upper.bottom",
                              "Obstacle = boundary : lower.top", "Law = tied"})
                   : "") +
           section("Time", {"End = 1", "Steps = 3"}) + tolerance("1e-10");
  }

  void compare_with_whole()
  {
    const Run whole = solve(file("whole.prm", dragged(false)));
    const Run cut   = solve(file("cut.prm", dragged(true)));
    const auto a = whole.summary(), b = cut.summary();
    const auto &floor   = b["contact"]["boundaries"][0];
    const double force  = a["contact"]["normal_force"];
    const double energy = a["energy"]["strain"];
    const auto is_near  = [](const double x, const double y, const double scale) {
      return std::abs(x - y) < 1e-8 * scale;
    };
    out() << "cut and tied: certified " << yes(whole.converged && cut.converged)
          << ", partly sliding " << yes(floor["slip"] > 0 && floor["stick"] > 0)
          << ", tied " << b.at("contact").at("boundaries").at(1).at("tied").get<int>()
          << ", as the whole "
          << yes(is_near(force, floor["normal_force"], force) &&
                 is_near(a["contact"]["tangential_force"][0],
                         floor["tangential_force"][0], force) &&
                 is_near(energy, b["energy"]["strain"], energy))
          << std::endl;
  }

  // Radii 20, 30, 40, suction of 25 inside: 4.8942 between them (Lamé).
  void pull_a_shell()
  {
    const auto shell = [](const std::string &name, const std::string &radii) {
      return section("Body " + name,
                     {"Type = generator", "Generator = quarter_hyper_shell",
                      "Generator arguments = 0,0,0 : " + radii + " : 0 : true",
                      "Young's modulus = 1e5", "Poisson ratio = 0.3"});
    };
    std::string held;
    for (const std::string name : {"inner", "outer"})
      held += (held.empty() ? "" : " | ") + name + ".2 : 0; free; free | " + name +
              ".3 : free; 0; free | " + name + ".4 : free; free; 0";
    const std::string prm =
      file("shell.prm",
           shell("inner", "20 : 30") + shell("outer", "30 : 40") +
             section("Boundary conditions",
                     {"Prescribed displacement = " + held, "Pressure = inner.0 : -25",
                      "Contact boundary = inner.1", "Obstacle = boundary : outer.0"}) +
             tied + tolerance("1e-9"));
    double error[2];
    bool are_certified = true;
    for (const unsigned int level : {0, 1})
      {
        const Run run =
          solve(prm, {"Geometry/Global refinement=" + std::to_string(level + 1),
                      "Body outer/Refinement=1"});
        const auto contact = run.summary()["contact"]["boundaries"][0];
        are_certified      = are_certified && run.converged;
        error[level]       = std::abs(contact["normal_force"].get<double>() /
                                        contact["area"].get<double>() / -4.8942 -
                                      1.);
      }
    out() << "shell: certified " << yes(are_certified) << ", tension to 2 % "
          << yes(error[1] < 0.02) << ", three times as near on cells of half the size "
          << yes(error[1] < error[0] / 3.) << std::endl;
  }

  // Two cubes, one clamped at its base up to the joint, where its nodes cannot be those
  // that are tied; and both above a floor that they do not touch, whose nodes of the
  // joint stay tied.
  void hold_a_rim()
  {
    const auto cubes = [](const std::string &more, const std::string &side) {
      return brick("left", "1,1,1", "4,4,4", "0;0;0") +
             brick("right", "1,1,1", "4,4,4", "1;0;0") +
             section("Boundary conditions", {"Traction = left.left : 0; 0; 1",
                                             "Prescribed displacement = " + more}) +
             section("Contact pair joint",
                     {"Boundary = right.left", "Obstacle = boundary : left.right",
                      "Law = tied", "Slave side = " + side});
    };
    const auto energy = [](const std::string &prm) {
      const Run run = solve(file("rim.prm", prm + tolerance("1e-10")));
      return run.converged ? run.summary()["energy"]["strain"].get<double>() : 0.;
    };
    const double held = energy(cubes("right.bottom : 0; 0; 0", "obstacle"));
    out() << "held rim: the other side is chosen "
          << yes(std::abs(energy(cubes("right.bottom : 0; 0; 0", "automatic")) - held) <
                 1e-8 * held)
          << std::endl;

    const double alone = energy(cubes("right.right : 0; 0; 0", "boundary"));
    std::string floors;
    for (const std::string name : {"left", "right"})
      floors += section("Contact pair floor of " + name,
                        {"Boundary = " + name + ".bottom", "Obstacle = foundation",
                         "Initial gap = 1", "Law = frictionless"});
    out() << "nodes of two contacts stay tied "
          << yes(std::abs(energy(floors + cubes("right.right : 0; 0; 0", "boundary")) -
                          alone) < 1e-8 * alone)
          << std::endl;
  }

  std::string hanging(const std::string &held)
  {
    return brick("ceiling", "2,2,1", "4,4,2", "0;0;1") +
           brick("weight", "1,1,1", "3,3,3", "0.3;0.5;0") +
           section("Boundary conditions",
                   {"Gravity = 0; 0; -10", "Prescribed displacement = " + held,
                    "Contact boundary = weight.top",
                    "Obstacle = boundary : ceiling.bottom"}) +
           tied + tolerance("1e-9");
  }

  void hang_a_body()
  {
    const Run run      = solve(file("hanging.prm", hanging("ceiling.top : 0; 0; 0")));
    const double force = run.summary()["contact"]["boundaries"][0]["normal_force"];
    out() << "hanging: certified " << yes(run.converged) << ", tension is the weight "
          << yes(std::abs(force + 10.) < 1e-7) << std::endl;
    out() << "nothing holds both: "
          << how_it_ends(file("falling.prm", hanging("ceiling.left : 0; 0; free")),
                         method)
          << std::endl;
  }

  // A ball that begins above a coated block: it is brought to where it touches.
  void press_a_coating()
  {
    const Run run            = solve(file(
                 "coating.prm",
                 brick("block", "2,2,1", "3,3,2", "0;0;-1") +
                   brick("coating", "2,2,0.2", "8,8,2", "0;0;0") +
                   section("Boundary conditions",
                           {"Prescribed displacement = block.bottom : 0; 0; 0"}) +
                   section("Contact pair bond", {"Boundary = coating.bottom",
                                                 "Obstacle = boundary : block.top", "Law = tied"}) +
                   section("Contact pair ball",
                           {"Boundary = coating.top", "Obstacle = sphere : 1.05; 0.95; 4.21; 4",
                            "Force = 0; 0; -3", "Law = frictionless"}) +
                   tolerance("1e-9")));
    const auto summary       = run.summary();
    const unsigned int steps = summary["solver"]["newton_steps"];
    const double force       = summary["contact"]["boundaries"][1]["normal_force"];
    out() << "pressed coating: certified " << yes(run.converged) << ", force "
          << yes(std::abs(force - 3.) < 1e-2) << ", Newton steps at most 6 "
          << yes(steps <= 6) << std::endl;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try_all_methods();
  for (const std::string name : {"newton", "newton multigrid"})
    {
      out() << "-- " << name << std::endl;
      method = {"Contact solver/Method=" + name};
      patch_test();
      compare_with_whole();
      pull_a_shell();
      hold_a_rim();
      hang_a_body();
    }
  press_a_coating();
}
