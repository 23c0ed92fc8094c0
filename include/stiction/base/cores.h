#pragma once

#include <mpi.h>

namespace stiction
{
  /// The ranks of a machine and the cores that they may run on.
  struct SharedCores
  {
    unsigned int n_ranks = 1, n_cores = 1;
  };

  /// That of the machine with the most ranks to a core. What counts as a core
  /// is what the system schedules processes on, without those that this set of
  /// processes was kept from. Collective.
  SharedCores shared_cores(MPI_Comm communicator);
} // namespace stiction
