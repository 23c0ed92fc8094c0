#pragma once

#include <stiction/output/history/step_result.h>

#include <nlohmann/json_fwd.hpp>

#include <mpi.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  /// The certified steps of a run and the files that grow with them: whatever ends
  /// the run, those of the steps before can be read. All is collective, and throws
  /// InputError if a file cannot be written.
  class StepHistory
  {
  public:
    StepHistory(std::string directory, MPI_Comm communicator);

    /// Takes a step, and appends a row for each contact boundary to history.csv and
    /// one to energy.csv.
    void add(StepResult step);

    /// Enters files of the last step, NAME_NUMBER.EXTENSION, into NAME.pvd, which
    /// ParaView opens as a series over t.
    void add_file(const std::string &name, const std::string &extension);

    /// "_0001": what the names of the files of the last step have.
    std::string tag() const;

    const std::vector<StepResult> &steps() const { return steps_; }

    /// Whether files of a step were entered.
    bool has_files() const { return !series_.empty(); }

    /// Of all steps together.
    EnergyBalance::Step energy() const;

    /// The list "steps" of summary.json.
    ///
    /// @param elastic_solve_seconds 0: not measured.
    nlohmann::json to_json(double elastic_solve_seconds) const;

    /// All of it, for another run that goes on.
    nlohmann::json progress() const;

    /// Goes on where another run was: its rows come first.
    ///
    /// @param in_place whether its files are in this directory, for the series.
    void go_on_from(const nlohmann::json &progress, bool in_place);

  private:
    using Rows = std::string (*)(const StepResult &);

    /// Appends the last step, in a file that this run has not begun all of them.
    void append(const std::string &file, const std::string &header, Rows rows) const;

    const std::string directory_;
    const MPI_Comm communicator_;
    std::vector<StepResult> steps_;
    bool has_begun_ = false; ///< its files
    /// By the names of files: times and what is shown there.
    std::map<std::string, std::vector<std::pair<double, std::string>>> series_;
  };
} // namespace stiction
