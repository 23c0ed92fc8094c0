// Contact pairs of elastic bodies. Exact: the patch test on meshes that do not match,
// plane and tilted, under friction, with a narrower body, with nodes that hang, of degree
// 2; two mirrored bodies as one on a rigid plane; spherical shells in one another; a
// stack that contact alone holds, to the limit of sliding; a foundation that is nearly
// rigid. Either side of a pair gives the same but for the error of the mesh.

#include <stiction/contact/interface/contact_boundary.h>

#include "how_it_ends.h"
#include "several_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace stiction;

namespace
{
  // What all problems are solved with, beside their own settings.
  Settings method;

  Run solve(const std::string &prm, const Settings &settings)
  {
    return Run(prm, method + settings);
  }

  const std::string tolerance = section("Contact solver", {"Tolerance = 1e-11"});

  // The largest relative difference of pressures from p.
  double error_of_pressure(const Run &run, const double p)
  {
    const auto &surface = run.problem->contact_surface();
    const auto &lambda  = run.problem->state().lambda;
    double error        = 0.;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      error = std::max(error, std::abs(lambda(i) / surface.areas()(i) / p - 1.));
    const Eigen::Index n = 2 * surface.n_nodes();
    return std::max(error, lambda.tail(n).lpNorm<Eigen::Infinity>() /
                             lambda.lpNorm<Eigen::Infinity>());
  }

  // Two bricks that pressure holds together, nothing else; the upper one is moved by its
  // rotation, too, which leaves them one column.
  std::string column(const std::string &turn, const std::string &E_of_upper = "1000")
  {
    return brick("lower", "1,1,1", "5,4,2", "0;0;0", turn) +
           brick("upper", "1,1,1", "3,3,2", turn == "0;0;0;0;0;1;0" ? "0;0;1" : "", turn,
                 E_of_upper) +
           section("Boundary conditions", {"Pressure = lower.bottom : 1 | upper.top : 1",
                                           "Contact boundary = lower.top",
                                           "Obstacle = boundary : upper.bottom"}) +
           section("Friction", {"Law = coulomb", "Coefficient = 0.5"}) + tolerance;
  }

  void check_pressure(const std::string &what, const std::string &prm,
                      const Settings &settings)
  {
    const Run run = solve(prm, settings);
    out() << what << ": certified alone " << yes(certified_alone(run))
          << ", pressure to 1e-9 " << yes(error_of_pressure(run, 1.) < 1e-9) << std::endl;
  }

  void try_all_dual_methods()
  {
    for (const Method &dual : all_methods())
      if (dual.name.find("multigrid") == std::string::npos)
        check_pressure(dual.name, file("plane.prm", column("0;0;0;0;0;1;0")),
                       dual.settings + Settings{"Contact solver/Tolerance=1e-10"});
  }

  void patch_test()
  {
    const std::string plane = file("plane.prm", column("0;0;0;0;0;1;0"));
    // upper: first on the lower one, then turned with it
    const std::string turn = "0;0;0; 1;2;0.5; 30";
    std::string text       = column(turn);
    const auto place       = text.find("Translation = \n");
    // the z axis turned: the third column of the rotation matrix
    const double a[] = {1. / std::sqrt(5.25), 2. / std::sqrt(5.25),
                        0.5 / std::sqrt(5.25)};
    const double c   = std::cos(dealii::numbers::PI / 6.),
                 s   = std::sin(dealii::numbers::PI / 6.);
    text.replace(place, 14,
                 "Translation = " + three((1. - c) * a[0] * a[2] + s * a[1],
                                          (1. - c) * a[1] * a[2] - s * a[0],
                                          c + (1. - c) * a[2] * a[2]));
    const std::string tilted = file("tilted.prm", text);
    const std::string soft   = file("soft.prm", column("0;0;0;0;0;1;0", "10") + "\n");

    const std::string punch = file(
      "punch.prm",
      brick("lower", "1,1,1", "5,5,2", "0;0;0") +
        brick("upper", "0.6,0.6,1", "4,4,2", "0;0;1") +
        section(
          "Boundary conditions",
          {"Pressure = lower.bottom : 1 | upper.top : 1 | lower.top : 1 - (x < 0.6) * "
           "(y < 0.6)",
           "Contact boundary = lower.top", "Obstacle = boundary : upper.bottom"}) +
        section("Friction", {"Law = coulomb", "Coefficient = 0.5"}) + tolerance);

    for (const std::string side : {"boundary", "obstacle"})
      {
        const Settings slave = {"Boundary conditions/Slave side=" + side};
        check_pressure("plane, " + side, plane, slave);
        check_pressure("tilted, " + side, tilted, slave);
        check_pressure("narrower, " + side, punch, slave);
        check_pressure("degree 2, " + side, plane,
                       slave + Settings{"Geometry/Element degree=2"});
        check_pressure("hanging nodes, " + side, plane,
                       slave + Settings{"Geometry/Contact refinement=1",
                                        "Geometry/Contact refinement where=0.5-x"});
        check_pressure("degree 2, hanging nodes, " + side, plane,
                       slave + Settings{"Geometry/Element degree=2",
                                        "Geometry/Contact refinement=1",
                                        "Geometry/Contact refinement where=0.5-x"});
        check_pressure("refined, " + side, plane,
                       slave + Settings{"Body upper/Refinement=1"});
      }
    check_pressure("soft, frictionless", soft, {"Friction/Law=frictionless"});
  }

  // Two bricks with a curved gap between them, pressed on one another.
  std::string mirrored(const bool is_one)
  {
    const std::string held = is_one
                               ? "upper.top : 0; 0; -0.01"
                               : "upper.top : 0; 0; -0.01 | lower.bottom : 0; 0; 0.01";
    return brick("upper", "1,1,1", "4,4,4", "0;0;0") +
           (is_one ? "" : brick("lower", "1,1,1", "4,4,4", "0;0;-1")) +
           section("Boundary conditions",
                   {"Prescribed displacement = " + held,
                    "Contact boundary = upper.bottom",
                    is_one ? "Obstacle = foundation" : "Obstacle = boundary : lower.top",
                    std::string("Initial gap = ") + (is_one ? "" : "2 * ") +
                      "(0.02 * (x - 0.3)^2 + 0.01 * (y - 0.6)^2)",
                    "Slave side = boundary"}) +
           section("Friction", {"Law = frictionless"}) + tolerance;
  }

  void compare_with_rigid_plane()
  {
    const Run one      = solve(file("one.prm", mirrored(true)), {});
    const Run two      = solve(file("two.prm", mirrored(false)), {});
    const auto &forces = one.problem->state().lambda;
    const double error = (two.problem->state().lambda - forces).norm() / forces.norm();
    const bool is_open =
      (forces.head(forces.size() / 3).array() < 1e-8 * forces.maxCoeff()).any();
    out() << "mirrored: certified " << yes(one.converged && two.converged)
          << ", partly open " << yes(is_open) << ", as one on a rigid plane to 1e-8 "
          << yes(error < 1e-8) << std::endl;
  }

  double normal_force(const Run &run) { return run.summary()["contact"]["normal_force"]; }

  void exchange_sides()
  {
    const std::string prm =
      file("sides.prm", brick("upper", "1,1,1", "3,3,3", "0;0;1") +
                          brick("lower", "1.2,1.2,1", "4,4,3", "-0.1;-0.1;0") +
                          section("Boundary conditions",
                                  {"Prescribed displacement = upper.top : 0.01; 0; -0.02 "
                                   "| lower.bottom : 0; 0; 0",
                                   "Contact boundary = upper.bottom",
                                   "Obstacle = boundary : lower.top",
                                   "Initial gap = 0.02 * ((x - 0.4)^2 + (y - 0.5)^2)"}) +
                          section("Friction", {"Law = coulomb", "Coefficient = 0.3"}) +
                          section("Contact solver", {"Tolerance = 1e-9"}));
    double difference[2];
    bool are_certified = true;
    for (const unsigned int level : {0, 1})
      {
        const Settings refined = {"Geometry/Global refinement=" +
                                  std::to_string(level + 1)};
        const Run a =
          solve(prm, refined + Settings{"Boundary conditions/Slave side=boundary"});
        const Run b =
          solve(prm, refined + Settings{"Boundary conditions/Slave side=obstacle"});
        are_certified     = are_certified && a.converged && b.converged;
        difference[level] = std::abs(normal_force(a) / normal_force(b) - 1.);
      }
    out() << "either side: certified " << yes(are_certified) << ", force alike to 1 % "
          << yes(difference[0] < 0.01)
          << ", three times as near on cells of half the size "
          << yes(difference[1] < difference[0] / 3.) << std::endl;
  }

  // Radii 20, 30, 40, pressure 25 inside: 4.8942 between them (Lamé).
  void put_shells_in_one_another()
  {
    const auto shell = [](const std::string &name, const std::string &radii) {
      return section("Body " + name,
                     {"Type = generator", "Generator = quarter_hyper_shell",
                      "Generator arguments = 0,0,0 : " + radii + " : 0 : true",
                      "Young's modulus = 1e5", "Poisson ratio = 0.3"});
    };
    const std::string rollers =
      "%.2 : 0; free; free | %.3 : free; 0; free | %.4 : free; free; 0";
    std::string held = rollers + " | " + rollers;
    for (const std::string name : {"inner", "inner", "inner", "outer", "outer", "outer"})
      held.replace(held.find('%'), 1, name);
    const std::string prm = file(
      "shells.prm", shell("inner", "20 : 30") + shell("outer", "30 : 40") +
                      section("Boundary conditions",
                              {"Prescribed displacement = " + held,
                               "Pressure = inner.0 : 25", "Contact boundary = inner.1",
                               "Obstacle = boundary : outer.0", "Mesh gap = removed"}) +
                      section("Friction", {"Law = frictionless"}) +
                      section("Contact solver", {"Tolerance = 1e-9"}));
    double error[2];
    bool are_certified = true;
    for (const unsigned int level : {0, 1})
      {
        const Run run =
          solve(prm, {"Geometry/Global refinement=" + std::to_string(level + 1),
                      "Body outer/Refinement=1"});
        are_certified   = are_certified && run.converged;
        const auto &all = run.summary()["contact"];
        error[level] =
          std::abs(normal_force(run) / all["area"].get<double>() / 4.8942 - 1.);
      }
    out() << "shells: certified " << yes(are_certified) << ", pressure to 2 % "
          << yes(error[1] < 0.02) << ", three times as near on cells of half the size "
          << yes(error[1] < error[0] / 3.) << std::endl;
  }

  std::string stack(const double pull)
  {
    return brick("lower", "1,1,1", "4,4,2", "0;0;0") +
           brick("middle", "1,1,0.5", "3,3,1", "0;0;1") +
           brick("upper", "1,1,1", "5,5,2", "0;0;1.5") +
           section("Boundary conditions",
                   {"Prescribed displacement = lower.bottom : 0; 0; 0",
                    "Traction = upper.bottom : 0; 0; 0", "Pressure = upper.top : 1",
                    "Body force = " + exact(pull) + "; 0; 0"}) +
           section("Contact pair one",
                   {"Boundary = lower.top", "Obstacle = boundary : middle.bottom",
                    "Law = coulomb", "Coefficient = 0.4"}) +
           section("Contact pair two",
                   {"Boundary = middle.top", "Obstacle = boundary : upper.bottom",
                    "Law = coulomb", "Coefficient = 0.2"}) +
           section("Contact solver", {"Tolerance = 1e-9"});
  }

  void stack_blocks()
  {
    const Run run =
      solve(file("stack.prm", stack(0.)),
            {"Contact pair one/Law=frictionless", "Contact pair two/Law=frictionless",
             "Boundary conditions/Prescribed displacement=lower.bottom : free; free; 0 "
             "| lower.left : 0; free; free | lower.front : free; 0; free"});
    out() << "stack: certified " << yes(run.converged) << ", pressure to 1e-8 "
          << yes(error_of_pressure(run, 1.) < 1e-8) << std::endl;
    // the pull on the upper one is its volume's, of both its and the middle one's
    for (const double pull : {0.1999, 0.2001})
      out() << "pulled by " << pull << ": "
            << how_it_ends(file("pulled.prm", stack(pull)), method) << std::endl;
  }

  // Two blocks on a coarser plate, whose top is in both pairs.
  void share_a_side()
  {
    const std::string prm = file(
      "shared.prm", brick("plate", "3,1,0.5", "12,4,1", "0;0;0") +
                      brick("one", "1,1,1", "2,2,2", "0;0;0.5") +
                      brick("two", "1,1,1", "3,3,2", "2;0;0.5") +
                      section("Boundary conditions",
                              {"Pressure = one.top : 1 | two.top : 1",
                               "Prescribed displacement = plate.bottom : 0; 0; 0"}) +
                      section("Contact pair one",
                              {"Boundary = plate.top", "Obstacle = boundary : one.bottom",
                               "Law = coulomb", "Coefficient = 0.3"}) +
                      section("Contact pair two",
                              {"Boundary = plate.top", "Obstacle = boundary : two.bottom",
                               "Law = coulomb", "Coefficient = 0.3"}) +
                      section("Contact solver", {"Tolerance = 1e-9"}));
    const Run run     = solve(prm, {});
    const auto &parts = run.summary()["contact"]["boundaries"];
    const bool are_1  = std::abs(parts[0]["normal_force"].get<double>() - 1.) < 1e-8 &&
                       std::abs(parts[1]["normal_force"].get<double>() - 1.) < 1e-8;
    out() << "a side in two pairs: certified " << yes(run.converged) << ", forces on "
          << parts[0]["name"].get<std::string>() << " and "
          << parts[1]["name"].get<std::string>() << ", both of 1 " << yes(are_1)
          << std::endl;
  }

  // Twelve blocks in a pile on a slope, of which the joint below the tenth bears least.
  void pile_up()
  {
    const auto pile = [](const double slope) {
      std::string text;
      for (unsigned int i = 1; i <= 12; ++i)
        {
          const std::string name = "b" + std::to_string(i);
          text += brick(name, "1,1,0.5", i % 2 == 0 ? "3,3,1" : "2,2,1",
                        three(0., 0., 0.5 * (i - 1)));
          if (i > 1)
            text += section("Contact pair " + name,
                            {"Boundary = " + name + ".bottom",
                             "Obstacle = boundary : b" + std::to_string(i - 1) + ".top",
                             "Law = coulomb",
                             i == 10 ? "Coefficient = 0.02" : "Coefficient = 0.5"});
        }
      return text +
             section("Boundary conditions",
                     {"Prescribed displacement = b1.bottom : 0; 0; 0",
                      "Gravity = " + exact(slope) + "; 0; -1"}) +
             section("Contact solver", {"Tolerance = 1e-6"});
    };
    for (const double slope : {0.0199, 0.0201})
      out() << "pile on a slope of " << slope << ": "
            << how_it_ends(file("pile.prm", pile(slope)), method) << std::endl;
  }

  // A block on a plate on a slope of 0.25, which tips if it is higher than 4, and a beam
  // whose centre is beyond the edge of the plate at x = 2, or not.
  void tip()
  {
    const auto problem = [](const std::string &body, const double slope) {
      return brick("plate", "2,1,0.5", "8,4,1", "0;0;-0.5") + body +
             section("Boundary conditions",
                     {"Prescribed displacement = plate.bottom : 0; 0; 0",
                      "Gravity = " + exact(slope) + "; 0; -1",
                      "Contact boundary = body.bottom",
                      "Obstacle = boundary : plate.top"}) +
             section("Friction", {"Law = coulomb", "Coefficient = 0.5"}) +
             section("Contact solver", {"Tolerance = 1e-6"});
    };
    for (const double height : {3.99, 4.01})
      out() << "height " << height << " on a slope: "
            << how_it_ends(file("high.prm", problem(brick("body", "1,1," + exact(height),
                                                          "3,3,4", "0.5;0;0"),
                                                    0.25)),
                           method)
            << std::endl;
    for (const double begin : {0.75, 0.81})
      out() << "centre at x = " << begin + 1.2 << " beyond the edge at 2 or not: "
            << how_it_ends(file("beam.prm", problem(brick("body", "2.4,1,0.5", "6,3,1",
                                                          exact(begin) + ";0;0"),
                                                    0.)),
                           method)
            << std::endl;
  }

  void lay_on_stiff_foundation()
  {
    const auto problem = [](const bool is_rigid) {
      return brick("block", "2,1,1", "6,3,3", "0;0;0") +
             (is_rigid ? ""
                       : brick("ground", "3,2,1", "4,3,2", "-0.5;-0.5;-1",
                               "0;0;0;0;0;1;0", "1e9")) +
             section("Boundary conditions",
                     {std::string("Prescribed displacement = block.left : 0; 0; 0") +
                        (is_rigid ? "" : " | ground.bottom : 0; 0; 0"),
                      "Traction = block.top : 2; 0; -20 | block.right : 3; 2; 1",
                      "Contact boundary = block.bottom",
                      is_rigid ? "Obstacle = foundation"
                               : "Obstacle = boundary : ground.top"}) +
             section("Friction", {"Law = coulomb", "Coefficient = 0.3"}) +
             section("Contact solver", {"Tolerance = 1e-9"});
    };
    const Run rigid    = solve(file("rigid.prm", problem(true)), {});
    const Run stiff    = solve(file("stiff.prm", problem(false)), {});
    const auto &forces = rigid.problem->state().lambda;
    out() << "stiff foundation: certified " << yes(rigid.converged && stiff.converged)
          << ", forces of the rigid one to 1e-4 "
          << yes((stiff.problem->state().lambda - forces).norm() < 1e-4 * forces.norm())
          << std::endl;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::vector<std::string> names = {"newton multigrid"};
  if (is_alone()) // dual methods do the same on each rank
    {
      try_all_dual_methods();
      names.insert(names.begin(), "newton");
    }
  for (const std::string &name : names)
    {
      out() << "-- " << name << std::endl;
      method = {"Contact solver/Method=" + name};
      patch_test();
      compare_with_rigid_plane();
      exchange_sides();
      put_shells_in_one_another();
      stack_blocks();
      share_a_side();
      pile_up();
      tip();
      lay_on_stiff_foundation();
    }
}
