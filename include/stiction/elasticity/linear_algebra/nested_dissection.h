#pragma once

#include <mpi.h>

#include <vector>

namespace stiction
{
  /// A fill-reducing elimination order for a sparse Cholesky factorisation
  /// that keeps a list of unknowns for last: METIS' nested dissection of the
  /// graph of the nodes to be eliminated.
  ///
  /// Given this way, the rest of a factorisation is the Schur complement on
  /// the list, reached with the least fill. Collective.
  ///
  /// @param rows, columns this rank's entries (i, j) of one triangle of the
  ///   matrix, counted from 1.
  /// @param n the order of the matrix; three unknowns in a row are one node.
  /// @param last the list, counted from 1, in the order wanted.
  /// @return on rank 0 the position of each unknown in the order, counted
  ///   from 1 (MUMPS' PERM_IN); empty elsewhere.
  std::vector<int> nested_dissection(const std::vector<int> &rows,
                                     const std::vector<int> &columns, int n,
                                     const std::vector<int> &last, MPI_Comm communicator);
} // namespace stiction
