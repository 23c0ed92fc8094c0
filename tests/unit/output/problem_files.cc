// What is exported is a directory from which each way of importing gets the
// same problem; a second export leaves nothing of the first.

#include <stiction/output/problem/problem_files.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <set>

#include "problem_tests.h"

using namespace stiction;
using namespace problem_tests;

namespace
{
  const std::string directory = "results/new/export";

  void list_files()
  {
    std::set<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(directory))
      names.insert(entry.path().filename().string());
    std::cout << "files:";
    for (const std::string &name : names)
      std::cout << ' ' << name;
    std::cout << std::endl;
  }

  void show(const std::string &file)
  {
    std::cout << "---- " << file << '\n';
    std::ifstream in(directory + "/" + file);
    for (std::string line; std::getline(in, line);)
      if (line.find("written by stiction") == std::string::npos) // the version
        std::cout << line << '\n';
    std::cout << "----" << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::filesystem::remove_all("results");

  for (const bool coulomb : {true, false})
    {
      const DualProblem problem    = some_problem(4, coulomb, coulomb);
      const Eigen::VectorXd lambda = random(12, 1, -1.);
      if (coulomb)
        export_problem(directory, problem, lambda, problem.Q * lambda - problem.h);
      else
        export_problem(directory, problem);
      list_files();
      show("README.txt");

      for (const std::string way : {"", "/", "/Q.mtx", "/problem.hdf5"})
        std::cout << "import of DIRECTORY" << way << ": same bits "
                  << yes(same_bits(problem, import_problem(directory + way)))
                  << std::endl;
      std::filesystem::copy_file(directory + "/problem.hdf5", "results/other.h5",
                                 std::filesystem::copy_options::overwrite_existing);
      std::filesystem::copy_file(directory + "/Q.mtx", directory + "/other.mtx",
                                 std::filesystem::copy_options::overwrite_existing);
      std::cout << "of other names: same bits "
                << yes(same_bits(problem, import_problem("results/other.h5")) &&
                       same_bits(problem, import_problem(directory + "/other.mtx")))
                << std::endl;
      std::filesystem::remove(directory + "/other.mtx");
      std::filesystem::copy_file(directory + "/problem.hdf5", "results/problem.hdf5",
                                 std::filesystem::copy_options::overwrite_existing);
      std::cout << "directory with problem.hdf5 only: same bits "
                << yes(same_bits(problem, import_problem("results"))) << std::endl;
    }
  show("slip_bound.mtx");

  std::filesystem::create_directories("results/empty");
  write_text("results/problem.txt", "1");
  refused("nothing there", []() { import_problem("results/nothing"); });
  refused("no such hdf5", []() { import_problem("results/nothing.hdf5"); });
  refused("no such mtx", []() { import_problem("results/nothing/Q.mtx"); });
  refused("another file", []() { import_problem("results/problem.txt"); });
  refused("an empty directory", []() { import_problem("results/empty"); });
  refused("no contact node", []() { export_problem("results/none", DualProblem()); });
  refused("below a file", []() {
    export_problem("results/problem.txt/x", some_problem(1, true, false));
  });
  std::cout << "nothing made then: " << yes(!std::filesystem::exists("results/none"))
            << std::endl;
}
