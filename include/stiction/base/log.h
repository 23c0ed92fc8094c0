#pragma once

#include <stiction/base/directory_lock.h>

#include <mpi.h>

#include <array>
#include <chrono>
#include <fstream>
#include <mutex>
#include <sstream>
#include <string>

namespace stiction
{
  /// What the program says: on the screen at once and, from open_file() on, in
  /// log.txt too, with everything that was said before. Rank 0 speaks, the
  /// others are silent. May be used from several threads.
  class Log
  {
  public:
    explicit Log(MPI_Comm communicator);

    /// Prints one line.
    void line(const std::string &text = "");

    /// Starts the file. Nothing is said into it before, so that a run refused
    /// for its input leaves the log of an earlier one alone.
    ///
    /// Throws InputError on rank 0 if the file cannot be written, or if another run
    /// writes into its directory.
    void open_file(const std::string &name, bool appends = false);

    /// Ends the file once everything is said. Collective.
    ///
    /// Throws InputError if not all of it could be written, or if somebody removed it,
    /// with the results beside it.
    void close_file();

    /// How long nothing was said, in seconds.
    double seconds_of_silence() const;

  private:
    const MPI_Comm communicator_;
    const bool speaks_;
    /// Phases speaks from a thread of its own.
    mutable std::mutex mutex_;
    std::chrono::steady_clock::time_point last_line_;
    std::ostringstream so_far_;
    /// As long as a log is open its directory is its run's.
    DirectoryLock directory_lock_;
    std::string file_name_;
    std::ofstream file_;
  };

  /// printf into a string.
  std::string format(const char *pattern, ...) __attribute__((format(printf, 1, 2)));

  /// Numbers of one kind without those that are rounding: 0 for what is below
  /// 1e-12 of their Euclidean norm, or of the size of numbers from which they
  /// were computed.
  std::array<double, 3> without_rounding(std::array<double, 3> v, double size = 0.);

  /// The three components of a vector, each by this pattern,
  /// without_rounding().
  template<typename Vector>
  std::string format_vector(const char *pattern, const Vector &v, double size = 0.)
  {
    const auto w = without_rounding({{v[0], v[1], v[2]}}, size);
    return format(pattern, w[0]) + ", " + format(pattern, w[1]) + ", " +
           format(pattern, w[2]);
  }
} // namespace stiction
