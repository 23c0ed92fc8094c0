#include <stiction/base/cores.h>

#include <sched.h>

#include <array>

namespace stiction
{
  SharedCores shared_cores(MPI_Comm communicator)
  {
    MPI_Comm machine;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    int n_ranks = 1;
    MPI_Comm_size(machine, &n_ranks);

    // mpirun may have bound every rank to cores of its own
    cpu_set_t cores;
    CPU_ZERO(&cores);
    sched_getaffinity(0, sizeof(cores), &cores);
    MPI_Allreduce(MPI_IN_PLACE, &cores, sizeof(cores), MPI_BYTE, MPI_BOR, machine);
    MPI_Comm_free(&machine);

    struct
    {
      double ratio;
      int rank;
    } most{};
    const int n_cores = CPU_COUNT(&cores) > 0 ? CPU_COUNT(&cores) : n_ranks;
    most.ratio        = static_cast<double>(n_ranks) / n_cores;
    MPI_Comm_rank(communicator, &most.rank);
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE_INT, MPI_MAXLOC, communicator);
    std::array<int, 2> numbers = {{n_ranks, n_cores}};
    MPI_Bcast(numbers.data(), 2, MPI_INT, most.rank, communicator);

    SharedCores shared;
    shared.n_ranks = static_cast<unsigned int>(numbers[0]);
    shared.n_cores = static_cast<unsigned int>(numbers[1]);
    return shared;
  }
} // namespace stiction
