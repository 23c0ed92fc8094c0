#pragma once

#include <mpi.h>

namespace stiction
{
  class Log;
  class Parameters;

  /// Estimates in bytes, all ranks together: of a mesh of so many cells with
  /// all that is made on it, and of the dual operator, 0 if it is not
  /// assembled.
  double memory_for_mesh(const Parameters &parameters, double n_cells);
  double memory_for_dual_operator(const Parameters &parameters, double n_dual_unknowns,
                                  MPI_Comm communicator);

  /// Whether the dual operator, which 'newton multigrid' does without, fits beside what
  /// is there: into half of the memory that is left. Collective.
  bool has_memory_to_hand_over(const Parameters &parameters, double n_dual_unknowns,
                               MPI_Comm communicator);

  /// Throws InputError if a mesh of so many cells has too many for the program
  /// or cannot fit into the memory, before it is made. Collective.
  void require_memory_for_mesh(const Parameters &parameters, double n_cells,
                               MPI_Comm communicator);

  /// Throws InputError if the dual operator in the form of the parameter file
  /// cannot fit. Collective.
  void require_memory_for_dual_operator(const Parameters &parameters,
                                        double n_dual_unknowns, MPI_Comm communicator);

  /// Prints both, with that of the program itself, what the method 'newton multigrid' may
  /// take beside it where linear systems are hard, and what memory there is. Collective.
  void print_memory(Log &log, const Parameters &parameters, double n_cells,
                    double n_unknowns, double n_dual_unknowns, MPI_Comm communicator);
} // namespace stiction
