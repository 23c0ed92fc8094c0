#pragma once

// Small contact problems of any kind, by number, the same everywhere: boxes and
// half balls, one material or two whose moduli differ by up to 1e8, supports on
// soft layers, Coulomb's law with F up to 5, given friction or none, obstacles
// that are tilted, curved, far away in parts, or pressed on by a force.

#include "random_numbers.h"
#include "tests.h"

#include <stiction/output/results/report.h>

#include <chrono>
#include <cmath>

struct RandomProblem : private RandomNumbers
{
  explicit RandomProblem(const unsigned int number)
    : RandomNumbers(number)
  {
    settings = {"Output/Write solution=false", "Refinement/Estimate error=false",
                "Material/Young's modulus=1",
                "Material/Poisson ratio=" + exact(uniform(0., 0.45)),
                "Boundary conditions/Obstacle displacement=0; 0; 0"};
    if (uniform(0., 1.) < 0.75)
      make_box();
    else
      make_half_ball();
    choose_friction();
  }

  std::string file, description;
  Settings settings;

private:
  void add(const std::string &setting)
  {
    settings.push_back("Boundary conditions/" + setting);
  }

  // Stands on z = 0, is held at its top, or at its side if that is as stiff.
  void make_box()
  {
    file           = shipped("brick.prm");
    const double a = log_uniform(0.5, 3.), b = log_uniform(0.5, 3.);
    settings.push_back("Geometry/Table 1 level=0");
    settings.push_back("Geometry/Lengths=" + exact(a) + "," + exact(b) + ",1");
    settings.push_back("Geometry/Subdivisions=" + std::to_string(2 + one_of(4)) + "," +
                       std::to_string(2 + one_of(4)) + ",3");
    settings.push_back("Geometry/Global refinement=" + std::to_string(one_of(2)));
    description = "box";

    const unsigned int layers = one_of(3); // one material, soft above, below
    if (layers > 0)
      {
        softest = 1. / log_uniform(1., 1e8);
        settings.push_back(std::string("Material/Material ids=if(z ") +
                           (layers == 1 ? ">" : "<") + " 0.5, 1, 0)");
        settings.push_back("Material/Materials=1 : isotropic; " + exact(softest) +
                           "; 0.3");
        description += (layers == 1 ? ", above " : ", below ") + exact(softest);
      }

    const double strain = log_uniform(1e-5, 1e-2);
    const double aside  = log_uniform(1e-2, 10.) * strain;
    const bool at_side  = layers == 0 && one_of(2) == 0;
    if (one_of(2) == 0)
      {
        add(std::string("Prescribed displacement=") + (at_side ? "0" : "5") + ":" +
            three(aside, uniform(-1., 1.) * aside, -strain));
        add("Traction=3:0;0;" + exact(-0.1 * softest * strain));
        description += ", moved";
      }
    else
      {
        add(std::string("Prescribed displacement=") + (at_side ? "0" : "5") + ":0;0;0");
        const double p = softest * strain, q = 0.3 * softest * aside;
        add("Traction=1:" + three(q, 0., -p) +
            " | 3:" + three(0., uniform(-1., 1.) * q, -p));
        description += ", loaded";
      }

    const double size = std::max(a, b);
    switch (one_of(4))
      {
        case 0:
          add("Initial gap=0");
          break;
        case 1:
          add("Obstacle=plane:0;0;0;" +
              three(log_uniform(1e-5, 0.1), uniform(0., 0.01), 1.));
          description += ", tilted";
          break;
        case 2:
          add("Obstacle=sphere:" + exact(a / 2) + ";" + exact(b / 2) + ";-" +
              exact(20 * size) + ";" + exact(20 * size));
          description += ", sphere";
          break;
        default:
          add("Initial gap=" + exact(log_uniform(1e-4, 100.)) + "*x^2");
          description += ", far gaps";
      }
    press();
  }

  void make_half_ball()
  {
    file = shipped("half_ball.prm");
    settings.push_back("Geometry/Global refinement=" + std::to_string(1 + one_of(2)));
    add("Initial gap=0");
    add("Obstacle=plane:0;0;0;" + three(uniform(-0.2, 0.2), 0., 1.));
    const double depth = log_uniform(1e-5, 3e-2);
    add("Prescribed displacement=flat:" +
        three(log_uniform(1e-2, 1.) * depth, 0., -depth));
    description = "half ball";
    press();
  }

  // A force that the body bears without large strains.
  void press()
  {
    if (one_of(8) > 0)
      return;
    add("Obstacle force=0;0;" + exact(softest * log_uniform(1e-6, 1e-3)));
    description += ", pressed";
  }

  void choose_friction()
  {
    const unsigned int law = one_of(5);
    const auto say         = [&](const std::string &text) {
      settings.push_back("Friction/" + text);
    };
    if (law == 0)
      {
        say("Law=given");
        const double stress = log_uniform(1e-7, 1e-2);
        say("Slip stress=" + exact(stress));
        description += ", slip stress " + exact(stress);
      }
    else if (law == 1 && one_of(2) == 0)
      {
        say("Law=frictionless");
        description += ", frictionless";
      }
    else
      {
        const double F = one_of(3) == 0 ? uniform(1., 5.) : uniform(0., 1.);
        say("Law=coulomb");
        say("Coefficient=" + exact(F));
        description += ", F " + exact(F);
      }
  }

  double softest = 1.; // of Young's moduli
};

// What a method made of a problem: certified or not, how far its contact forces
// are from those of the first method that is certified, and why not.
struct Outcome
{
  std::string method;
  bool certified  = false;
  double distance = 0., seconds = 0.;
  std::string reason;
};

// The tolerance and what all methods made of it.
struct Comparison
{
  double tolerance = 1e-8;
  std::vector<Outcome> outcomes;

  // What certified contact forces have to agree to, relative.
  double agreement() const { return std::max(1e-6, 10. * tolerance); }
};

// What a user would ask for: 1e-8, and where newton is told that the digits do
// not carry so far, three times what it reached, which is told, too.
inline double tolerance_of(const RandomProblem &problem)
{
  constexpr double largest = 1e-4;
  double tolerance         = Comparison().tolerance;
  while (true)
    {
      const Run run(problem.file,
                    problem.settings +
                      Settings{"Contact solver/Method=newton",
                               "Contact solver/Tolerance=" + exact(tolerance)});
      const auto &certificate = run.problem->certificate();
      double reached          = 0.;
      for (const auto &figure : certificate.deciding_figures())
        reached = std::max(reached, figure.second);
      const std::string reason =
        stiction::explain(run.problem->status(), certificate, tolerance);
      if (run.converged || 3. * reached > largest ||
          reason.find("rounding") == std::string::npos)
        return tolerance;
      tolerance = 3. * reached;
    }
}

inline Comparison solve_by_all_methods(const RandomProblem &problem)
{
  Comparison comparison;
  comparison.tolerance    = tolerance_of(problem);
  const Settings settings = problem.settings + Settings{"Contact solver/Tolerance=" +
                                                        exact(comparison.tolerance)};
  Eigen::VectorXd forces;
  for (const auto &method : all_methods())
    {
      if (method.name == "by solves" || method.name == "newton multigrid, amg")
        continue;
      const auto start = std::chrono::steady_clock::now();
      Outcome outcome;
      outcome.method = method.name;
      try
        {
          const Run run(problem.file, settings + method.settings);
          outcome.certified = run.converged;
          if (run.converged)
            {
              const Eigen::VectorXd &lambda = run.problem->state().lambda;
              if (forces.size() == 0)
                forces = lambda;
              const double size = forces.norm();
              outcome.distance =
                size > 0. ? (lambda - forces).norm() / size : lambda.norm();
            }
          else
            outcome.reason = run.problem->status().reason;
        }
      catch (const std::exception &e)
        {
          outcome.reason = e.what();
        }
      outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      comparison.outcomes.push_back(outcome);
    }
  return comparison;
}
