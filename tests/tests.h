#ifndef stiction_tests_h
#define stiction_tests_h

// What the tests share. They print words and numbers of size one to be
// compared with a reference output.

#include <stiction/contact/certificate.h>
#include <stiction/contact/contact_surface.h>
#include <stiction/contact_problem.h>
#include <stiction/parameters.h>

#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

// The shipped parameter file of that name. SOURCE_DIR is the folder of the
// test.
inline std::string
shipped(const std::string &name)
{
  return SOURCE_DIR "/../../parameters/" + name;
}

inline const char *
yes(const bool condition)
{
  return condition ? "yes" : "NO";
}

// With all digits, for settings.
inline std::string
exact(const double value)
{
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

// A problem that was solved silently, with what it needs to stay alive.
struct Run
{
  Run(const std::string &file, std::vector<std::string> settings)
  {
    settings.emplace_back("Output/Directory=results");
    settings.emplace_back("Output/Print progress=false");
    std::ostringstream silence;
    std::streambuf *const screen = std::cout.rdbuf(silence.rdbuf());
    try
      {
        parameters.read(file, settings);
        problem   = std::make_unique<stiction::ContactProblem>(parameters,
                                                             MPI_COMM_WORLD);
        converged = problem->run();
      }
    catch (...)
      {
        std::cout.rdbuf(screen);
        throw;
      }
    std::cout.rdbuf(screen);
  }

  const nlohmann::json &
  summary() const
  {
    return problem->summary();
  }

  stiction::Parameters parameters;
  std::unique_ptr<stiction::ContactProblem> problem;
  bool converged = false;
};

// The stream of rank 0.
inline std::ostream &
out()
{
  static std::ostream nowhere(nullptr);
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0
           ? std::cout
           : nowhere;
}

#endif
