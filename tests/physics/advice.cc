// Problems that do not converge, and what the program advises: never what is in
// use already, and whoever follows the advice has an answer that is certified.

#include "tests.h"

#include <stiction/output/results/report.h>

#include <algorithm>
#include <cmath>

namespace
{
  // What follows a text up to a quote, or nothing.
  std::string after(const std::string &sentence, const std::string &text)
  {
    const auto begin = sentence.find(text);
    if (begin == std::string::npos)
      return {};
    const auto from = begin + text.size();
    return sentence.substr(from, sentence.find('\'', from) - from);
  }

  // Whether a sentence names this method.
  bool names(const std::string &sentence, const std::string &value)
  {
    return sentence.find("= " + value + "'") != std::string::npos ||
           sentence.find("'" + value + "'") != std::string::npos;
  }

  // The entries that the sentence wants changed, as they are to be.
  Settings follow(const std::string &advice, const Run &run)
  {
    Settings changes;
    const auto choose = [&](const std::string &entry) {
      const std::string value = after(advice, "'" + entry + " = ");
      if (!value.empty())
        changes.push_back(entry + "=" + value);
    };
    choose("Contact solver/Method");
    choose("Contact solver/Disc solver");
    choose("Contact solver/Coulomb iteration");
    const std::string cap = "raise 'Contact solver/Maximum iterations'";
    if (advice.find(cap) != std::string::npos)
      {
        // where there were too few steps, no number is said
        const std::string more = after(advice, cap + " by about ");
        changes.push_back(
          "Contact solver/Maximum iterations=" +
          std::to_string(
            run.parameters.contact_solver.maximum_iterations +
            (more.empty() ? 100 : static_cast<unsigned int>(2. * std::stod(more)))));
      }
    if (advice.find("raise 'Contact solver/Tolerance' above") != std::string::npos)
      {
        double worst = 0.;
        for (const auto &figure : run.problem->certificate().deciding_figures())
          worst = std::max(worst, figure.second);
        changes.push_back("Contact solver/Tolerance=" + exact(3. * worst));
      }
    return changes;
  }

  struct Case
  {
    std::string name;
    Settings settings;
  };

  // A stiff block on a layer that is softer, dragged along and turned.
  Settings weakly_held(const std::string &soft)
  {
    return {"Geometry/Table 1 level=0",
            "Geometry/Lengths=2,2,1",
            "Geometry/Subdivisions=4,4,4",
            "Geometry/Global refinement=0",
            "Material/Poisson ratio=0.3",
            "Material/Young's modulus=2e11",
            "Material/Material ids=if(z < 0.25, 1, 0)",
            "Material/Materials=1 : isotropic; " + soft + "; 0.3",
            "Boundary conditions/Prescribed displacement=4 : 0; 0; 0",
            "Boundary conditions/Traction=1 : 2e6; 0; 5e6 | 0 : 0; 1e6; 3e6",
            "Boundary conditions/Contact boundary=5",
            "Friction/Coefficient=0.5",
            "Contact solver/Maximum iterations=60"};
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Settings small    = {"Geometry/Table 1 level=1"};
  std::vector<Case> cases = {
    {"weakly held, newton",
     weakly_held("2e1") + Settings{"Contact solver/Method=newton"}},
    {"weakly held, mpgp", weakly_held("2e8") + Settings{"Contact solver/Method=mpgp"}}};
  for (const std::string method :
       {"newton", "gauss seidel", "mpgp", "admm", "newton multigrid"})
    {
      const Settings chosen = {"Contact solver/Method=" + method};
      cases.push_back(
        {method + ", few iterations", small + chosen +
                                        Settings{"Contact solver/Maximum iterations=5",
                                                 "Contact solver/Tolerance=1e-10"}});
    }

  for (const Case &c : cases)
    {
      // each advice may be followed by another one
      Settings settings = c.settings;
      bool is_certified = false;
      bool names_own    = false;
      std::string changed, last;
      for (unsigned int k = 0; k < 4 && !is_certified; ++k)
        {
          const Run run(shipped("brick.prm"), settings);
          is_certified = run.converged;
          if (is_certified)
            break;
          const auto &chosen       = run.parameters.contact_solver;
          const std::string advice = stiction::explain(
            run.problem->status(), run.problem->certificate(), chosen.tolerance);
          names_own =
            names_own || names(advice, chosen.method) ||
            advice.find("Disc solver = " + chosen.disc_solver) != std::string::npos ||
            advice.find("Coulomb iteration = " + chosen.coulomb_iteration) !=
              std::string::npos;
          const Settings changes = follow(advice, run);
          if (changes.empty())
            break;
          for (const std::string &change : changes)
            {
              // more iterations may be advised more than once
              const std::string entry = change.substr(0, change.find('='));
              if (entry != last)
                changed += (changed.empty() ? "" : ", then ") + entry;
              last = entry;
            }
          settings = settings + changes;
        }
      out() << c.name << ": advised [" << changed << "], certified in the end "
            << yes(is_certified) << ", never what was in use " << yes(!names_own)
            << std::endl;
    }
}
