// What goes wrong outside of the program, made to happen: a library that is loaded
// before all others (LD_PRELOAD) and stands between the program and its system, its
// MPI and MUMPS. The environment says what goes wrong and when:
//
//   STICTION_FAULT=disk:N       the N-th change of a file below STICTION_FAULT_BELOW
//                               and all later ones find the disk full
//   STICTION_FAULT=removed:N    before the N-th change somebody removes that directory
//   STICTION_FAULT=nan:N        the N-th sum or maximum over all ranks is no number
//   STICTION_FAULT=signal:N     at the N-th one this process is asked to end (SIGTERM)
//   STICTION_FAULT=killed:N     at the N-th one the last rank is killed
//   STICTION_FAULT=solve:N      the N-th solve or Schur complement of MUMPS has a NaN
//   STICTION_FAULT=memory:N     the N-th factorisation of MUMPS gets no memory
//   STICTION_FAULT=shared:1     /dev/shm is full
//
// N = 0 counts alone; how many there were goes to the file STICTION_FAULT_COUNT.

#include <dmumps_c.h>
#include <mpi.h>

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <filesystem>
#include <limits>
#include <string>
#include <sys/uio.h>
#include <unistd.h>

namespace
{
  std::string variable(const char *name)
  {
    const char *const value = std::getenv(name);
    return value != nullptr ? value : "";
  }

  const std::string fault = variable("STICTION_FAULT");
  const std::string kind  = fault.substr(0, fault.find(':'));
  const long when = kind == fault ? 0 : std::atol(fault.c_str() + kind.size() + 1);
  const std::string below = variable("STICTION_FAULT_BELOW");

  struct Counter
  {
    long n = 0;

    ~Counter()
    {
      const std::string name = variable("STICTION_FAULT_COUNT");
      if (name.empty() || n == 0)
        return;
      if (FILE *const file = std::fopen(name.c_str(), "w"))
        {
          std::fprintf(file, "%ld\n", n);
          std::fclose(file);
        }
    }
  };
  Counter counter;

  // Whether it is this time's turn.
  bool happens(const char *what) { return kind == what && ++counter.n == when; }

  template<typename Function> Function *original(Function *, const char *name)
  {
    return reinterpret_cast<Function *>(dlsym(RTLD_NEXT, name));
  }

  std::string path_of(const int file)
  {
    char path[PATH_MAX];
    const auto n =
      readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), path, sizeof(path));
    return std::string(path, n < 0 ? 0 : n);
  }

  // A change of this file: whether it meets a full disk.
  bool is_refused(const char *path)
  {
    if (below.empty() || std::strncmp(path, below.c_str(), below.size()) != 0)
      return false;
    if (happens("removed"))
      {
        std::error_code error;
        std::filesystem::remove_all(below, error);
      }
    if (kind != "disk" || (++counter.n < when || when == 0))
      return false;
    errno = ENOSPC;
    return true;
  }

  bool is_refused(const int file) { return is_refused(path_of(file).c_str()); }

  bool is_full(const char *path)
  {
    const bool is_shared = std::strncmp(path, "/dev/shm", 8) == 0;
    if (is_shared && kind == "shared")
      errno = ENOSPC;
    return is_shared && kind == "shared";
  }

  bool is_full(const int file) { return is_full(path_of(file).c_str()); }
} // namespace

extern "C"
{
  ssize_t write(const int file, const void *data, const size_t n)
  {
    return is_refused(file) ? -1 : original(write, "write")(file, data, n);
  }

  ssize_t writev(const int file, const iovec *parts, const int n)
  {
    return is_refused(file) ? -1 : original(writev, "writev")(file, parts, n);
  }

  int rename(const char *from, const char *to) noexcept
  {
    return is_refused(to) ? -1 : original(rename, "rename")(from, to);
  }

  int mkdir(const char *path, const mode_t mode) noexcept
  {
    return is_refused(path) ? -1 : original(mkdir, "mkdir")(path, mode);
  }

  FILE *fopen64(const char *path, const char *mode)
  {
    // a file that is there is opened whether there is space or not
    if (mode[0] != 'r' && access(path, F_OK) != 0 && is_refused(path))
      return nullptr;
    return original(fopen64, "fopen64")(path, mode);
  }

  int ftruncate(const int file, const off_t size) noexcept
  {
    return is_full(file) ? -1 : original(ftruncate, "ftruncate")(file, size);
  }

  int posix_fallocate(const int file, const off_t begin, const off_t size)
  {
    return is_full(file)
             ? ENOSPC
             : original(posix_fallocate, "posix_fallocate")(file, begin, size);
  }

  int MPI_Allreduce(const void *mine, void *all, const int n, MPI_Datatype type,
                    MPI_Op op, MPI_Comm communicator)
  {
    const int status = PMPI_Allreduce(mine, all, n, type, op, communicator);
    if (type == MPI_DOUBLE && n > 0 && happens("nan"))
      static_cast<double *>(all)[0] = std::numeric_limits<double>::quiet_NaN();
    if (happens("signal"))
      std::raise(SIGTERM);
    int rank, n_ranks;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    PMPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
    if (rank == n_ranks - 1 && happens("killed"))
      std::raise(SIGKILL);
    return status;
  }

  void dmumps_c(DMUMPS_STRUC_C *id)
  {
    const int job = id->job;
    if (job == 2 && happens("memory"))
      {
        id->infog[0] = id->info[0] = -13;
        return;
      }
    original(dmumps_c, "dmumps_c")(id);
    int rank;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank != 0)
      return;
    const bool is_schur = job == 2 && id->size_schur > 0;
    if ((job == 3 || is_schur) && happens("solve"))
      (is_schur ? id->schur : id->rhs)[0] = std::numeric_limits<double>::quiet_NaN();
  }
}
