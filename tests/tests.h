#pragma once

// What the tests share. They print words and numbers of size one to be
// compared with a reference output.

#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/qp/node_status.h>
#include <stiction/base/blas_choice.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>

#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

// As the program does: before MPI is initialised.
inline const bool has_chosen_blas = (stiction::choose_blas_kernels(), true);

// The shipped parameter file of that name.
inline std::string shipped(const std::string &name) { return PARAMETERS "/" + name; }

inline const char *yes(const bool condition) { return condition ? "yes" : "NO"; }

// With all digits, for settings.
inline std::string exact(const double value)
{
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

// Three components as entries want them.
inline std::string three(const double x, const double y, const double z)
{
  return exact(x) + ";" + exact(y) + ";" + exact(z);
}

// 'Section/Entry=value', as on the command line; later ones count.
using Settings = std::vector<std::string>;

inline Settings operator+(Settings a, const Settings &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// A way to solve a problem.
struct Method
{
  std::string name;
  Settings settings;
  bool solves_given = true; // false: differs for Coulomb's law only
};

inline bool is_alone()
{
  return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
}

// Of several ranks each does the same in a dual method: one stands for all of them there.
inline const std::vector<Method> &all_methods()
{
  static const std::vector<Method> methods = [] {
    std::vector<Method> all = {{"newton", {"Contact solver/Method=newton"}}};
    if (is_alone())
      all.insert(all.end(), {{"gauss seidel", {"Contact solver/Method=gauss seidel"}},
                             {"fixed point",
                              {"Contact solver/Method=newton",
                               "Contact solver/Coulomb iteration=fixed point"},
                              false},
                             {"mpgp", {"Contact solver/Method=mpgp"}},
                             {"admm", {"Contact solver/Method=admm"}}});
    all.insert(
      all.end(),
      {{"by solves", {"Contact solver/Method=newton", "Dual operator/Form=by solves"}},
       {"newton multigrid", {"Contact solver/Method=newton multigrid"}},
       {"newton multigrid, amg",
        {"Contact solver/Method=newton multigrid", "Stiffness solver/Type=amg"}}});
    return all;
  }();
  return methods;
}

// A problem that was solved silently, with what it needs to stay alive.
struct Run
{
  // @param restart the directory of a run that this one goes on from.
  Run(const std::string &file, Settings settings, const std::string &restart = "",
      MPI_Comm communicator = MPI_COMM_WORLD)
  {
    settings.emplace_back("Output/Directory=results");
    settings.emplace_back("Output/Print progress=false");
    std::ostringstream silence;
    std::streambuf *const screen = std::cout.rdbuf(silence.rdbuf());
    try
      {
        parameters.read(file, settings);
        problem =
          std::make_unique<stiction::ContactProblem>(parameters, communicator, restart);
        converged = problem->run();
      }
    catch (...)
      {
        std::cout.rdbuf(screen);
        throw;
      }
    std::cout.rdbuf(screen);
  }

  const nlohmann::json &summary() const { return problem->summary(); }

  stiction::Parameters parameters;
  std::unique_ptr<stiction::ContactProblem> problem;
  bool converged = false;
};

// Of the contact forces, relative.
inline double distance(const Run &run, const Run &reference)
{
  const auto &lambda = reference.problem->state().lambda;
  return (run.problem->state().lambda - lambda).norm() / lambda.norm();
}

// The stream of rank 0.
inline std::ostream &out()
{
  static std::ostream nowhere(nullptr);
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0 ? std::cout
                                                                       : nowhere;
}
