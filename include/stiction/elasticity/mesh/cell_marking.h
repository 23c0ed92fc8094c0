#pragma once

#include <deal.II/lac/vector.h>

#include <mpi.h>

#include <vector>

namespace stiction
{
  /// The cells with the largest values that together make up this part of the
  /// sum over all cells of all ranks (bulk criterion: W. Dörfler, A convergent
  /// adaptive algorithm for Poisson's equation, 1996).
  ///
  /// Cells with values within a thousandth of the smallest one that is taken
  /// are taken as well: what symmetry makes equal is marked alike, on any
  /// number of ranks. Collective.
  ///
  /// @param values ≥ 0, by active cells of this rank; zero for those of other
  ///   ranks, which are not marked.
  /// @param fraction in (0, 1].
  std::vector<bool> mark_largest_cells(const dealii::Vector<double> &values,
                                       double fraction, MPI_Comm communicator);
} // namespace stiction
