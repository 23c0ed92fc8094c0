#ifndef stiction_memory_h
#define stiction_memory_h

#include <mpi.h>

namespace stiction
{
  class Parameters;

  /// The memory that all ranks together may use, in bytes: that of the
  /// machines they run on, or less if the process is limited. Collective.
  double
  available_memory(MPI_Comm communicator);

  /// What a mesh with so many cells and all that belongs to it take, in bytes,
  /// about.
  double
  memory_for_mesh(const Parameters &parameters, double n_cells);

  /// What the dual operator in the form of the parameter file takes on all
  /// ranks, in bytes; 0 where it is not assembled.
  ///
  /// @param n_dual_unknowns 3m.
  double
  memory_for_dual_operator(const Parameters &parameters,
                           double n_dual_unknowns,
                           MPI_Comm communicator);

  /// Throws InputError if the mesh of the parameter file cannot fit into the
  /// memory, before it is made. Collective.
  void
  require_memory_for_mesh(const Parameters &parameters, MPI_Comm communicator);

  /// Throws InputError if the dual operator in the form of the parameter file
  /// cannot fit. Collective.
  void
  require_memory_for_dual_operator(const Parameters &parameters,
                                   double n_dual_unknowns,
                                   MPI_Comm communicator);
} // namespace stiction

#endif
