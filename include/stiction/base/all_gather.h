#pragma once

#include <deal.II/base/mpi.h>

#include <type_traits>
#include <vector>

namespace stiction
{
  /// The list, made of those of all ranks in their order. Sent as they are: deal.II's
  /// all_gather() compresses, which takes longer than all that is done with large
  /// lists. Collective.
  template<typename Entry>
  std::vector<Entry> all_gather(const std::vector<Entry> &own, MPI_Comm communicator)
  {
    static_assert(std::is_trivially_copyable<Entry>::value, "sent as bytes");
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
    const auto n_own           = static_cast<int>(own.size());
    std::vector<int> sizes(n_ranks), begins(n_ranks, 0);
    MPI_Allgather(&n_own, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
    for (unsigned int r = 1; r < n_ranks; ++r)
      begins[r] = begins[r - 1] + sizes[r - 1];
    std::vector<Entry> all(static_cast<std::size_t>(begins.back() + sizes.back()));
    MPI_Datatype entry;
    MPI_Type_contiguous(sizeof(Entry), MPI_BYTE, &entry);
    MPI_Type_commit(&entry);
    MPI_Allgatherv(own.data(), n_own, entry, all.data(), sizes.data(), begins.data(),
                   entry, communicator);
    MPI_Type_free(&entry);
    return all;
  }
} // namespace stiction
