#pragma once

#include <deal.II/base/types.h>

#include <Epetra_CrsMatrix.h>

namespace stiction
{
  /// Calls back with the columns and values of a row of this rank.
  template<typename Callback>
  void for_each_entry(const Epetra_CrsMatrix &matrix,
                      const dealii::types::global_dof_index row, const Callback &callback)
  {
    int n_entries = 0, *columns = nullptr;
    double *values = nullptr;
    matrix.ExtractMyRowView(matrix.LRID(static_cast<int>(row)), n_entries, values,
                            columns);
    const int *const numbers = matrix.ColMap().MyGlobalElements(); // GCID() is slow
    for (int k = 0; k < n_entries; ++k)
      callback(static_cast<dealii::types::global_dof_index>(numbers[columns[k]]),
               values[k]);
  }
} // namespace stiction
