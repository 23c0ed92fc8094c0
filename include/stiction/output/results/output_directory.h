#pragma once

#include <nlohmann/json_fwd.hpp>

#include <mpi.h>

#include <string>

namespace stiction
{
  class ConvergenceHistory;
  class Log;
  struct OutputParameters;
  class ParameterFile;

  /// Throws InputError if the directories for output cannot be written to or
  /// be made. Changes nothing. Collective.
  void require_writable_output(const OutputParameters &output,
                               const ParameterFile &source, MPI_Comm communicator);

  /// Makes the output directory, opens log.txt in it, removes the other files
  /// of an earlier run, which must not be read together with those of this one,
  /// and writes used_parameters.prm, whose text is given. Collective. Throws
  /// InputError, before anything is changed, if it cannot be written.
  ///
  /// @param goes_on whether the earlier run goes on: then nothing is removed, and
  ///   log.txt goes on, too.
  void open_output_directory(const OutputParameters &output, const ParameterFile &source,
                             const std::string &used_parameters, Log &log,
                             MPI_Comm communicator, bool goes_on = false);

  /// Writes convergence.csv. Collective.
  void write_history(const ConvergenceHistory &history, const std::string &directory,
                     MPI_Comm communicator);

  /// Writes summary.json, the last file of a run. Collective.
  void write_summary(const nlohmann::json &summary, const std::string &directory,
                     MPI_Comm communicator);
} // namespace stiction
