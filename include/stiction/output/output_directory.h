#ifndef stiction_output_output_directory_h
#define stiction_output_output_directory_h

#include <nlohmann/json_fwd.hpp>

#include <mpi.h>

#include <string>

namespace stiction
{
  class ConvergenceHistory;
  class Log;
  class Parameters;

  /// Makes the output directory, opens log.txt in it and removes summary.json:
  /// an earlier success must not stand beside a later failure. Collective.
  /// Throws InputError, before anything is changed, if it cannot be written.
  void
  prepare_output(const Parameters &parameters, Log &log, MPI_Comm communicator);

  /// Writes convergence.csv and used_parameters.prm. Collective.
  void
  write_run_files(const Parameters &parameters,
                  const ConvergenceHistory &history,
                  MPI_Comm communicator);

  /// Writes summary.json, the last file of a run. Collective.
  void
  write_summary(const nlohmann::json &summary,
                const std::string &directory,
                MPI_Comm communicator);

  /// The section "program" of summary.json. Collective.
  nlohmann::json
  program_to_json(MPI_Comm communicator);

  /// The largest memory of all ranks together so far, in MB. Collective.
  double
  peak_memory(MPI_Comm communicator);
} // namespace stiction

#endif
