#pragma once

#include <mpi.h>

namespace stiction
{
  /// The memory that all ranks together may use, in bytes: that of the
  /// machines they run on, or less if the process is limited. Collective.
  double available_memory(MPI_Comm communicator);
} // namespace stiction
