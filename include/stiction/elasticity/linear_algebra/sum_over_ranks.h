#pragma once

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

namespace stiction
{
  /// Adds up the entries of a dense matrix, vector or array over all ranks, in place.
  /// Collective.
  template<typename Values> void sum_over_ranks(Values &values, MPI_Comm communicator)
  {
    using Number = typename Values::value_type;
    dealii::Utilities::MPI::sum(
      dealii::ArrayView<const Number>(values.data(), values.size()), communicator,
      dealii::ArrayView<Number>(values.data(), values.size()));
  }
} // namespace stiction
