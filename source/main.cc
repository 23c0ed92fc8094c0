#include <stiction/contact_problem.h>
#include <stiction/errors.h>
#include <stiction/parameters.h>

#include <deal.II/base/mpi.h>

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>
#include <vector>

namespace
{
  enum ExitStatus
  {
    certified     = 0,
    input_error   = 1,
    not_converged = 2
  };

  struct CommandLine
  {
    std::string file, output;
    std::vector<std::string> settings;
    bool validate = false, print_parameters = false;
  };

  int
  run(const CommandLine &arguments)
  {
    using namespace stiction;
    if (arguments.file.empty())
      throw InputError("FILE.prm is missing, 'stiction --help' shows how to "
                       "call the program and 'stiction --print-parameters' "
                       "prints a complete parameter file.");
    auto settings = arguments.settings;
    if (!arguments.output.empty())
      settings.push_back("Output/Directory=" + arguments.output);

    Parameters parameters;
    parameters.read(arguments.file, settings);
    ContactProblem problem(parameters, MPI_COMM_WORLD);
    if (arguments.validate)
      {
        problem.validate();
        return certified;
      }
    return problem.run() ? certified : not_converged;
  }
} // namespace



int
main(int argc, char *argv[])
{
  // the linear algebra is parallel over ranks; more threads would only fight
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool speaks =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  CommandLine arguments;
  CLI::App app("Contact of an elastic body with friction, in three "
               "dimensions, with a certificate.",
               "stiction");
  app.add_option("FILE", arguments.file, "Parameter file");
  app
    .add_option("--set",
                arguments.settings,
                "'Section/Entry=value', goes before the file; any number")
    ->expected(1)
    ->take_all();
  app.add_option("--output", arguments.output, "Directory for all results");
  app.add_flag("--validate",
               arguments.validate,
               "Read and check everything, solve nothing");
  app.add_flag("--print-parameters",
               arguments.print_parameters,
               "Print the complete commented default file");
  app.set_version_flag("--version", "stiction " STICTION_VERSION);
  app.footer("Exit status: 0 certified, 1 bad input, 2 not converged.");

  const auto refuse = [&](const std::string &sentence) {
    if (speaks)
      std::cerr << "stiction: " << sentence << std::endl;
    return input_error;
  };

  try
    {
      app.parse(argc, argv);
      if (arguments.print_parameters)
        {
          if (speaks)
            std::cout << stiction::Parameters::default_file();
          return certified;
        }
      return run(arguments);
    }
  catch (const CLI::Success &wish) // --help, --version
    {
      if (speaks)
        app.exit(wish);
      return certified;
    }
  catch (const CLI::ParseError &error)
    {
      return refuse(std::string(error.what()) +
                    ", 'stiction --help' shows what is allowed.");
    }
  catch (const stiction::InputError &error)
    {
      return refuse(error.what());
    }
  catch (const std::bad_alloc &)
    {
      std::cerr << "stiction: not enough memory for this problem, use a "
                   "coarser mesh, 'Dual operator/Form = by solves' or "
                   "'Stiffness solver/Type = amg'."
                << std::endl;
    }
  catch (const std::exception &error)
    {
      std::cerr << "stiction: internal error: " << error.what() << std::endl;
    }
  // one rank alone may be here: the others must not wait for it
  MPI_Abort(MPI_COMM_WORLD, input_error);
  return input_error;
}
