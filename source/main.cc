#include <stiction/base/errors.h>
#include <stiction/base/interrupt.h>
#include <stiction/base/text/in_words.h>
#include <stiction/base/text/utf8.h>
#include <stiction/base/blas_choice.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/dual_contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>

#include <deal.II/base/mpi.h>

#include <CLI/CLI.hpp>

#include <cctype>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace
{
  enum ExitStatus
  {
    certified     = 0,
    input_error   = 1,
    not_converged = 2,
    interrupted   = 3
  };

  // What the program is called with.
  struct CommandLine
  {
    std::string file;
    std::optional<std::string> output, export_directory, problem, restart;
    std::vector<std::string> settings;
    bool validate = false, print_parameters = false, print_output_directory = false;
  };

  void declare_options(CLI::App &app, CommandLine &arguments)
  {
    app.add_option("FILE", arguments.file, "Parameter file");
    app
      .add_option("--set", arguments.settings,
                  "'Section/Entry=value' in place of the file's, repeatable")
      ->expected(1)
      ->take_all();
    app.add_option("--output", arguments.output, "Directory for all results");
    app.add_option("--export", arguments.export_directory,
                   "Directory for Q, h, friction and the solution");
    auto *const problem =
      app.add_option("--problem", arguments.problem,
                     "Problem of an FCLIB file, Q.mtx or an exported directory");
    app
      .add_option("--restart", arguments.restart,
                  "Go on from the checkpoint in this directory")
      ->excludes(problem);
    app.add_flag("--validate", arguments.validate, "Check everything, solve nothing")
      ->excludes(problem);
    app.add_flag("--print-parameters", arguments.print_parameters,
                 "Print all entries with what they are");
    app.add_flag("--print-output-directory", arguments.print_output_directory,
                 "Print it, solve nothing");
    app.set_version_flag("--version", "stiction " STICTION_VERSION);
    app.footer("Exit status: 0 certified, 1 bad input, 2 not converged, 3 "
               "interrupted.\nCtrl-C ends the run after its step, with all files "
               "of what is reached then,\nand with checkpoints it can go on with "
               "--restart from its last step;\na second one ends it at once.");
  }

  // A sentence on an option of one value that stands several times, if there is one.
  std::string repeated_option(const CLI::App &app)
  {
    for (const CLI::Option *const option : app.get_options())
      if (option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw &&
          option->count() > 1)
        return option->get_name() + " = " + stiction::in_quotes(option->results()) +
               ", must stand once.";
    return "";
  }

  bool is_first_rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  // What was made stays alive until main() ends: to destroy parallel objects
  // is collective, and an exception may have been thrown on one rank alone.
  struct Program
  {
    stiction::Parameters parameters;
    std::unique_ptr<stiction::ContactProblem> problem;
    std::unique_ptr<stiction::DualContactProblem> dual_problem;
  };

  int run(Program &program, const CommandLine &arguments)
  {
    using namespace stiction;
    if (arguments.print_parameters)
      {
        if (is_first_rank())
          std::cout << Parameters::default_file();
        return certified;
      }
    if (arguments.problem && arguments.problem->empty())
      throw InputError("--problem = '', must name a file or a directory.");
    if (arguments.restart && arguments.restart->empty())
      throw InputError("--restart = '', must name the output directory of a run.");
    if (arguments.file.empty() && !arguments.problem)
      throw InputError("FILE.prm is missing, 'stiction --help' shows how to "
                       "call the program and 'stiction --print-parameters' "
                       "prints a complete parameter file.");
    throw_on_all_ranks(MPI_COMM_WORLD, [&]() { // their files may differ
      program.parameters.read(arguments.file, arguments.settings, arguments.output,
                              arguments.export_directory, !arguments.problem);
    });
    program.parameters.source.require(
      arguments.problem || !program.parameters.dual_operator.symmetric_part,
      "Dual operator/Symmetric part",
      "is for problems from files (--problem), that of a body is symmetric");
    if (arguments.print_output_directory)
      {
        if (is_first_rank())
          std::cout << program.parameters.output.directory << std::endl;
        return certified;
      }
    const auto status = [](const bool is_certified, const SolveStatus &solution) {
      return is_certified           ? certified
             : solution.interrupted ? interrupted
                                    : not_converged;
    };
    if (arguments.problem)
      {
        program.dual_problem = std::make_unique<DualContactProblem>(
          *arguments.problem, program.parameters, MPI_COMM_WORLD);
        const bool is_certified = program.dual_problem->run();
        return status(is_certified, program.dual_problem->status());
      }
    program.problem = std::make_unique<ContactProblem>(program.parameters, MPI_COMM_WORLD,
                                                       arguments.restart.value_or(""));
    if (arguments.validate)
      {
        program.problem->validate();
        return certified;
      }
    const bool is_certified = program.problem->run();
    return status(is_certified, program.problem->status());
  }

  // One line that a terminal can show, whatever the user's file had in it.
  std::string printable(std::string sentence)
  {
    constexpr std::size_t at_most = 600; // what is cut might cut a character
    const bool is_utf8            = sentence.size() <= at_most &&
                         stiction::first_byte_not_utf8(sentence) == std::string::npos;
    for (char &c : sentence)
      if (std::iscntrl(static_cast<unsigned char>(c)) != 0 ||
          (!is_utf8 && (c & 0x80) != 0))
        c = '?';
    if (sentence.size() > at_most)
      sentence = sentence.substr(0, at_most / 2) + " ... " +
                 sentence.substr(sentence.size() - at_most / 2);
    return sentence;
  }

  // All ranks end with the same sentence: the first one says it.
  int refuse(const std::string &sentence)
  {
    stiction::ignore_interrupts();
    if (is_first_rank())
      std::cerr << "stiction: " << printable(sentence) << std::endl;
    return input_error;
  }

  // Where one rank alone may have failed, the others must not wait for it. If
  // all have failed, the first one speaks and ends them.
  int end_all_ranks(const std::string &sentence)
  {
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
      return refuse(sentence);
    if (!is_first_rank())
      std::this_thread::sleep_for(std::chrono::seconds(2));
    std::cerr << "stiction: " << printable(sentence) << std::endl;
    MPI_Abort(MPI_COMM_WORLD, input_error);
    return input_error;
  }
} // namespace

int main(int argc, char *argv[])
{
  stiction::choose_blas_kernels();
  // the linear algebra is parallel over ranks; more threads would only fight
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  CommandLine arguments;
  CLI::App app("Contact of an elastic body with friction, in three "
               "dimensions, with a certificate.",
               "stiction");
  declare_options(app, arguments);

  stiction::watch_for_interrupts(is_first_rank(), interrupted);
  Program program;

  try
    {
      app.parse(argc, argv);
      const int status = run(program, arguments);
      if (!std::cout.flush())
        return refuse("standard output: cannot be written, must have space; a run's "
                      "log.txt says the same.");
      return status;
    }
  catch (const CLI::Success &wish) // --help, --version
    {
      if (is_first_rank())
        app.exit(wish);
      return certified;
    }
  catch (const CLI::ParseError &error)
    {
      const std::string repeated = repeated_option(app);
      return refuse(!repeated.empty() ? repeated
                                      : std::string(error.what()) +
                                          ", 'stiction --help' shows what is allowed.");
    }
  catch (const stiction::InputError &error)
    {
      return refuse(error.what());
    }
  catch (const std::bad_alloc &)
    {
      return end_all_ranks(
        arguments.problem
          ? "not enough memory for this problem, its Q must fit into memory "
            "several times."
          : "not enough memory for this problem, use a coarser mesh, 'Dual operator/Form "
            "= by solves' or 'Contact solver/Method = newton multigrid'.");
    }
  catch (const std::exception &error)
    {
      return end_all_ranks(std::string("internal error: ") + error.what());
    }
}
