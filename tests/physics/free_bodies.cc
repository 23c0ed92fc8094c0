// Bodies that nothing but contact holds. Exact: a column under pressure; a body whose
// supports bear nothing has the contact forces of one without supports; the limits of
// sliding and tipping. All methods, on all kinds of meshes; between obstacles that are
// pressed on; half held; dropped onto its table; load histories at whose end it slides
// or is lifted; where nothing resists it is left where it is.

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include "how_it_ends.h"

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  const std::string block = shipped("block_on_slope.prm");

  // A cube of weight 1.
  const Settings cube = {
    "Geometry/Lengths=1,1,1",       "Geometry/Subdivisions=2,2,2",
    "Geometry/Global refinement=1", "Material/Young's modulus=1000",
    "Material/Density=1",           "Boundary conditions/Gravity=0;0;-1",
    "Contact solver/Tolerance=1e-9"};

  const Settings on_slope = {"Boundary conditions/Gravity=0.25;0;-1"};

  const Eigen::VectorXd &lambda(const Run &run) { return run.problem->state().lambda; }

  // The force on the body at a contact boundary.
  dealii::Tensor<1, 3> force(const Run &run, const unsigned int boundary = 0)
  {
    const auto &on_body =
      run.summary()["contact"]["boundaries"][boundary]["force_on_body"];
    return dealii::Tensor<1, 3>({on_body[0], on_body[1], on_body[2]});
  }

  // The mean displacement of the nodes that do not hang.
  dealii::Tensor<1, 3> mean_displacement(const Run &run)
  {
    const LinearElasticity &elasticity = run.problem->elasticity();
    dealii::Tensor<1, 3> sum;
    double n = 0.;
    for (const Body::Node &node : elasticity.body().locally_owned_nodes())
      if (!elasticity.is_hanging(node.dofs[0]))
        {
          n += 1.;
          for (unsigned int c = 0; c < 3; ++c)
            sum[c] += run.problem->state().u(node.dofs[c]);
        }
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD) /
           dealii::Utilities::MPI::sum(n, MPI_COMM_WORLD);
  }

  // A pressure of 1000 Pa on a column of height 2 and E = 1e6: it is 0.002 shorter, and
  // its middle 0.001 lower.
  void press_column()
  {
    const Settings column =
      cube + Settings{"Geometry/Lengths=1,0.5,2",
                      "Geometry/Subdivisions=2,1,2",
                      "Material/Young's modulus=1e6",
                      "Boundary conditions/Gravity=",
                      "Boundary conditions/Traction=top : 0; 0; -1000",
                      "Friction/Law=frictionless"};
    const std::vector<Settings> bodies = {
      {},
      {"Geometry/Element degree=2"},
      {"Geometry/Contact refinement=1"},
      {"Geometry/Global refinement=3"},
      {"Refinement/Adaptive steps=1"},
      {"Boundary conditions/Obstacle=plane : 0; 0; -0.1; 0; 0; 1"},
      {"Boundary conditions/Initial gap=0.01"}};
    bool are_certified = true, are_left = true;
    double error     = 0.;
    const auto check = [&](const Settings &settings) {
      const Run run(block, column + settings);
      are_certified       = are_certified && run.converged;
      const auto &surface = run.problem->contact_surface();
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        error =
          std::max(error, std::abs(lambda(run)(i) / surface.areas()(i) / 1000. - 1.));
      const double energy = run.summary()["energy"]["strain"];
      error               = std::max(error, std::abs(energy / 0.5 - 1.));
      const auto mean     = mean_displacement(run);
      are_left = are_left && std::abs(mean[0]) < 1e-12 && std::abs(mean[1]) < 1e-12;
    };
    for (const Method &method : all_methods())
      check(method.settings);
    for (const Settings &body : bodies)
      for (const std::string method : {"newton multigrid", "newton"})
        check(body + Settings{"Contact solver/Method=" + method});
    out() << "column: certified " << yes(are_certified)
          << ", pressure and energy to 1e-7 " << yes(error < 1e-7)
          << ", left where nothing resists " << yes(are_left) << std::endl;
  }

  // Three points that bear nothing.
  void hold_without_forces()
  {
    const Settings smooth = cube + Settings{"Friction/Law=frictionless",
                                            "Boundary conditions/Traction=right : 0; 0; "
                                            "-0.3 * z"};
    const Settings held   = {"Boundary conditions/Prescribed points=0;0;1 : 0;0;free "
                               "| 1;0;1 : free;0;free"};
    for (const std::string method : {"newton", "newton multigrid"})
      {
        const Settings by = {"Contact solver/Method=" + method};
        const Run free(block, smooth + by);
        const Run supported(block, smooth + by + held);
        out() << method << ": certified " << yes(free.converged && supported.converged)
              << ", the forces of supports that bear nothing to 1e-7 "
              << yes(distance(free, supported) < 1e-7) << std::endl;
      }
  }

  std::string refusal(const Settings &settings) { return how_it_ends(block, settings); }

  void go_to_the_limit()
  {
    for (const std::string method : {"newton multigrid", "newton"})
      {
        const Settings by = cube + Settings{"Contact solver/Method=" + method,
                                            "Contact solver/Tolerance=1e-8"};
        out() << method << ":" << std::endl;
        for (const std::string slope : {"0.299", "0.2999", "0.29999", "0.30001"})
          out() << "  slope " << slope << ": "
                << refusal(by +
                           Settings{"Boundary conditions/Gravity=" + slope + ";0;-1"})
                << std::endl;
        for (const std::string height : {"3.9", "3.99", "4.01"})
          out() << "  height " << height << ": "
                << refusal(by + on_slope + Settings{"Geometry/Lengths=1,1," + height})
                << std::endl;
      }
    out() << "pulled off: "
          << refusal(cube + Settings{"Boundary conditions/Gravity=0;0;0.5"}) << std::endl;
    out() << "twisted off: "
          << refusal(cube +
                     Settings{"Boundary conditions/Traction=top : -1.5 * (y - 0.5); "
                              "1.5 * (x - 0.5); 0"})
          << std::endl;
  }

  void compare_methods()
  {
    const std::vector<Settings> laws = {
      {}, {"Friction/Law=given", "Friction/Slip stress=0.26"}};
    for (const Settings &law : laws)
      {
        const Run reference(block, cube + on_slope + law +
                                     Settings{"Contact solver/Method=newton multigrid"});
        out() << reference.problem->contact_surface().n_nodes() << " nodes, "
              << reference.summary()["solver"]["law"].get<std::string>() << ": certified "
              << yes(reference.converged) << std::endl;
        for (const Method &method : all_methods())
          if (law.empty() || method.solves_given)
            {
              const Run run(block, cube + on_slope + law + method.settings);
              out() << "  " << method.name << ": certified " << yes(run.converged)
                    << ", the same forces to 1e-5 "
                    << yes(distance(run, reference) < 1e-5) << ", the same place "
                    << yes(
                         (mean_displacement(run) - mean_displacement(reference)).norm() <
                         1e-6 * mean_displacement(reference).norm())
                    << std::endl;
            }
      }
  }

  void try_meshes()
  {
    const Settings ball = {"Geometry/Type=generator", "Geometry/Generator=hyper_ball",
                           "Geometry/Generator arguments=0,0,1 : 1 : false",
                           "Boundary conditions/Contact boundary=0",
                           "Boundary conditions/Obstacle=plane : 0; 0; 0; 0; 0; 1"};
    const std::vector<std::pair<std::string, Settings>> bodies = {
      {"degree 2", {"Geometry/Element degree=2"}},
      {"hanging nodes", {"Geometry/Contact refinement=1"}},
      {"degree 2, hanging nodes",
       {"Geometry/Element degree=2", "Geometry/Contact refinement=1"}},
      {"adaptive", {"Refinement/Adaptive steps=2"}},
      {"on a ridge", {"Boundary conditions/Obstacle=formula : z + 20 * (x - 0.5)^2"}},
      {"one layer, grids behind it",
       {"Geometry/Subdivisions=14,14,10", "Geometry/Global refinement=0"}},
      {"a ball", ball + Settings{"Geometry/Global refinement=2"}},
      {"a ball of degree 2",
       ball + Settings{"Geometry/Global refinement=1", "Geometry/Element degree=2"}}};
    for (const auto &[name, settings] : bodies)
      {
        const bool is_ball  = name.find("ball") != std::string::npos;
        const bool is_level = is_ball || name == "on a ridge";
        const Settings load = is_level ? Settings() : on_slope;
        const Run primal(block, cube + load + settings +
                                  Settings{"Contact solver/Method=newton multigrid"});
        const Run dual(block,
                       cube + load + settings + Settings{"Contact solver/Method=newton"});
        out() << name << ": certified " << yes(primal.converged && dual.converged)
              << ", the same forces to 1e-5 " << yes(distance(primal, dual) < 1e-5)
              << std::endl;
      }
  }

  // A sphere presses a block without weight on with 3 N, or two plates squeeze it.
  void press_between()
  {
    const Settings between =
      cube + Settings{"Boundary conditions/Gravity=", "Contact solver/Tolerance=1e-8",
                      "Boundary conditions/Contact boundary=bottom | top"};
    const Settings sphere = {
      "Boundary conditions/Obstacle=foundation | sphere : 0.5; 0.5; 2; 1",
      "Boundary conditions/Initial gap=0 | 0",
      "Boundary conditions/Obstacle force=0; 0; 0 | 0; 0; -3"};
    const Settings plates = {
      "Boundary conditions/Obstacle=foundation | foundation",
      "Boundary conditions/Obstacle displacement=0; 0; 0 | 0; 0; -0.001"};
    for (const Method &method : all_methods())
      {
        const Run pressed(block, between + sphere + method.settings);
        const Run squeezed(block, between + plates + method.settings);
        const auto below = force(squeezed), above = force(squeezed, 1);
        out() << method.name << ": certified "
              << yes(pressed.converged && squeezed.converged) << ", pressed with 3 "
              << yes(std::abs(force(pressed)[2] / 3. - 1.) < 1e-6)
              << ", squeezed alike from both sides "
              << yes((below + above).norm() < 1e-6 * above.norm())
              << ", by the half each "
              << yes(std::abs(mean_displacement(squeezed)[2] / -5e-4 - 1.) < 1e-5)
              << std::endl;
      }
  }

  // Rollers hold it along x alone.
  void hold_half()
  {
    const Settings rollers =
      cube + Settings{"Boundary conditions/Prescribed displacement=left : 0; free; free",
                      "Boundary conditions/Gravity=0.7; 0.1; -1"};
    for (const std::string method : {"newton", "newton multigrid"})
      {
        const Run run(block, rollers + Settings{"Contact solver/Method=" + method});
        const auto on_body = force(run);
        out() << method << ", half held: certified " << yes(run.converged)
              << ", forces where supports have none "
              << yes(std::abs(on_body[1] + 0.1) < 1e-7 &&
                     std::abs(on_body[2] - 1.) < 1e-7)
              << ", a part of the others "
              << yes(on_body[0] > -0.69 && on_body[0] < -0.01) << std::endl;
      }
  }

  // Gravity that turns until it slides at 0.732, or turns round at 0.625.
  void follow_histories()
  {
    const Settings steps =
      cube + Settings{"Time/Steps=2", "Time/End=1", "Time/Smallest step=0.01",
                      "Contact solver/Tolerance=1e-7"};
    for (const std::string method : {"newton multigrid", "newton"})
      for (const auto &[what, gravity] :
           {std::make_pair("slides", "0.41 * t; 0; -1"),
            std::make_pair("is lifted", "0; 0; -1 + 1.6 * t"),
            std::make_pair("is dropped and pushed", "0.1 * t; 0; if(t < 0.4, 0.5, -1)")})
        {
          const Run run(block, steps + Settings{"Contact solver/Method=" + method,
                                                std::string("Boundary conditions/"
                                                            "Gravity=") +
                                                  gravity});
          const auto &list = run.summary()["steps"];
          double reached   = 0.;
          for (const auto &step : list)
            if (step["certified"].get<bool>())
              reached = step["t"];
          const std::string reason = run.problem->status().reason;
          out() << method << ", " << what << ": reached t = " << reached
                << (reason.empty() ? "" : ", ")
                << reason.substr(0, reason.find(", where")) << std::endl;
        }
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  press_column();
  hold_without_forces();
  go_to_the_limit();
  compare_methods();
  try_meshes();
  press_between();
  hold_half();
  follow_histories();
}
