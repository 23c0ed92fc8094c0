#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/base/log.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/output/output_parameters.h>
#include <stiction/output/results/convergence_history.h>
#include <stiction/output/results/output_directory.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <regex>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
    // Whether a file is one that a run writes besides log.txt, by its name.
    bool is_ours(const std::string &name)
    {
      static const std::regex names(
        "((solution|contact|obstacle)(_[0-9]{4,}|_uncertified)?(\\.[0-9]{4,})?\\.(vtu|"
        "pvtu|pvd)|summary\\.json|used_parameters\\.prm|(convergence|forces|history|"
        "energy)\\.csv|(displacement|contact)(_[0-9]{4,}|_uncertified)?\\.csv|(picture|"
        "history|frame_[0-9]{4,})\\.png)(\\.new)?");
      return std::regex_match(name, names);
    }

    void remove_earlier_run(const std::string &directory)
    {
      namespace fs = std::filesystem;
      std::error_code error; // what cannot be removed cannot be written either
      std::vector<fs::path> files;
      for (const auto &entry : fs::directory_iterator(directory, error))
        if (entry.is_regular_file(error) && is_ours(entry.path().filename().string()))
          files.push_back(entry.path());
      for (const fs::path &file : files)
        fs::remove(file, error);
    }

    // Of all directories: in which, and the entry that says so.
    std::vector<std::pair<std::string, std::string>> directories(
      const OutputParameters &output, const ParameterFile &source)
    {
      std::vector<std::pair<std::string, std::string>> all;
      if (!output.export_directory.empty())
        all.emplace_back(output.export_directory,
                         source.describe("Output/Export directory"));
      all.emplace_back(output.directory, source.describe("Output/Directory"));
      return all;
    }
  } // namespace

  void require_writable_output(const OutputParameters &output,
                               const ParameterFile &source, MPI_Comm communicator)
  {
    do_on_first_rank(communicator, [&]() {
      for (const auto &[directory, entry] : directories(output, source))
        require_writable(directory, entry);
    });
  }

  void open_output_directory(const OutputParameters &output, const ParameterFile &source,
                             const std::string &used_parameters, Log &log,
                             MPI_Comm communicator, const bool goes_on)
  {
    const std::string &directory = output.directory;
    do_on_first_rank(communicator, [&]() {
      for (const auto &[name, entry] : directories(output, source))
        {
          std::error_code error;
          std::filesystem::create_directories(name, error);
          if (error)
            throw InputError(entry + ", cannot be written to, must be a directory that "
                                     "exists or can be made.");
          require_writable(name + "/.", entry);
        }
      log.open_file(directory + "/log.txt", goes_on);
      if (!goes_on)
        remove_earlier_run(directory);
      write_file(directory + "/used_parameters.prm",
                 [&](std::ostream &out) { out << used_parameters; });
    });
  }

  void write_history(const ConvergenceHistory &history, const std::string &directory,
                     MPI_Comm communicator)
  {
    do_on_first_rank(communicator, [&]() {
      write_file(directory + "/convergence.csv",
                 [&](std::ostream &out) { history.write(out); });
    });
  }

  void write_summary(const nlohmann::json &summary, const std::string &directory,
                     MPI_Comm communicator)
  {
    do_on_first_rank(communicator, [&]() {
      write_file(directory + "/summary.json", [&](std::ostream &out) {
        // paths may have any bytes
        out << summary.dump(2, ' ', false, nlohmann::json::error_handler_t::replace)
            << '\n';
      });
    });
  }
} // namespace stiction
