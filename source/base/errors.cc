#include <stiction/base/errors.h>

#include <deal.II/base/mpi.h>

namespace stiction
{
  void throw_on_all_ranks(MPI_Comm communicator, const std::function<void()> &work)
  {
    std::string message;
    try
      {
        work();
      }
    catch (const InputError &error)
      {
        message = error.what();
      }

    for (const std::string &one :
         dealii::Utilities::MPI::all_gather(communicator, message))
      if (!one.empty())
        throw InputError(one);
  }

  void do_on_first_rank(MPI_Comm communicator, const std::function<void()> &work)
  {
    throw_on_all_ranks(communicator, [&]() {
      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        work();
    });
  }
} // namespace stiction
