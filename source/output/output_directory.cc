#include <stiction/errors.h>
#include <stiction/output/convergence_history.h>
#include <stiction/output/files.h>
#include <stiction/output/log.h>
#include <stiction/output/output_directory.h>
#include <stiction/parameters.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace stiction
{
  namespace
  {
    bool
    is_first(MPI_Comm communicator)
    {
      return dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    }
  } // namespace



  void
  prepare_output(const Parameters &parameters, Log &log, MPI_Comm communicator)
  {
    const std::string &directory = parameters.output.directory;
    together(communicator, [&]() {
      if (!is_first(communicator))
        return;
      std::error_code error;
      const auto make = [&](const std::string &name, const char *entry) {
        require_writable(name, parameters.source.describe(entry));
        std::filesystem::create_directories(name, error);
        if (error)
          throw InputError(parameters.source.describe(entry) +
                           ", cannot be written to, must be a directory that "
                           "exists or can be made.");
        require_writable(name + "/.", parameters.source.describe(entry));
      };
      if (!parameters.output.export_directory.empty())
        make(parameters.output.export_directory, "Output/Export directory");
      make(directory, "Output/Directory");
      log.open_file(directory + "/log.txt");
      std::filesystem::remove(directory + "/summary.json", error);
    });
  }



  void
  write_run_files(const Parameters &parameters,
                  const ConvergenceHistory &history,
                  MPI_Comm communicator)
  {
    const std::string &directory = parameters.output.directory;
    together(communicator, [&]() {
      if (!is_first(communicator))
        return;
      write_file(directory + "/convergence.csv",
                 [&](std::ostream &out) { history.write(out); });
      write_file(directory + "/used_parameters.prm",
                 [&](std::ostream &out) { out << parameters.used_file(); });
    });
  }



  void
  write_summary(const nlohmann::json &summary,
                const std::string &directory,
                MPI_Comm communicator)
  {
    together(communicator, [&]() {
      if (is_first(communicator))
        write_file(directory + "/summary.json",
                   [&](std::ostream &out) { out << summary.dump(2) << '\n'; });
    });
  }



  nlohmann::json
  program_to_json(MPI_Comm communicator)
  {
    return {{"name", "stiction"},
            {"version", STICTION_VERSION},
            {"dealii", DEAL_II_PACKAGE_VERSION},
            {"build_type", STICTION_BUILD_TYPE},
            {"ranks", dealii::Utilities::MPI::n_mpi_processes(communicator)}};
  }



  double
  peak_memory(MPI_Comm communicator)
  {
    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    return dealii::Utilities::MPI::sum(
      static_cast<double>(memory.VmHWM) / 1024., communicator);
  }
} // namespace stiction
