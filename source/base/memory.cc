#include <stiction/base/memory.h>

#include <algorithm>
#include <sys/resource.h>
#include <unistd.h>

namespace stiction
{
  double available_memory(MPI_Comm communicator)
  {
    // the ranks that share a machine share its memory
    MPI_Comm machine;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    int n_neighbours = 1;
    MPI_Comm_size(machine, &n_neighbours);
    MPI_Comm_free(&machine);

    double mine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                  static_cast<double>(sysconf(_SC_PAGE_SIZE)) / n_neighbours;
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      mine = std::min(mine, static_cast<double>(limit.rlim_cur));

    double all = 0.;
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, communicator);
    return all;
  }
} // namespace stiction
