#pragma once

#include <mpi.h>

#include <functional>
#include <stdexcept>

namespace stiction
{
  /// Something the user gave cannot be used: a file, an entry, a value.
  ///
  /// what() is one sentence that names the place and says what is allowed.
  /// The program prints it once and ends with exit status 1. It must be thrown
  /// on all ranks or on none; see throw_on_all_ranks().
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// Runs @p work, which must not communicate, on every rank; if it throws an
  /// InputError on some ranks, throws that of the lowest one on all of them.
  ///
  /// For checks that only the owner of a cell can make: an exception on one
  /// rank alone would leave the others waiting for ever.
  void throw_on_all_ranks(MPI_Comm communicator, const std::function<void()> &work);

  /// The same for work of the first rank alone, such as writing a file.
  void do_on_first_rank(MPI_Comm communicator, const std::function<void()> &work);
} // namespace stiction
