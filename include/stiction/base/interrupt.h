#pragma once

#include <stiction/base/interrupted.h>

#include <mpi.h>

namespace stiction
{
  /// What becomes of SIGINT (Ctrl-C), SIGTERM and SIGUSR1, which mpirun hands
  /// on to its programs. At first one of them ends the process at once, saying
  /// that nothing was written, with this exit status.
  ///
  /// @param speaks whether this rank is the one that says so.
  void watch_for_interrupts(bool speaks, int exit_status);

  /// From now on there is an iterate worth keeping: the first signal is only
  /// noted, the second one ends the process.
  void keep_iterate_when_interrupted();

  /// From now on the program ends by itself: mpirun ends all ranks once one of
  /// them has ended with a status other than 0, and nobody should speak of that.
  void ignore_interrupts();

  /// Whether a signal came on any rank. Collective.
  bool is_interrupted(MPI_Comm communicator);

  /// Throws Interrupted if is_interrupted(). Collective.
  void stop_if_interrupted(MPI_Comm communicator);
} // namespace stiction
