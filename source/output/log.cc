#include <stiction/errors.h>
#include <stiction/output/log.h>

#include <deal.II/base/mpi.h>

#include <cstdarg>
#include <cstdio>
#include <iostream>

namespace stiction
{
  Log::Log(MPI_Comm communicator)
    : speaks_(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
  {
  }



  void
  Log::line(const std::string &text)
  {
    if (!speaks_)
      return;
    std::cout << text << std::endl;
    if (file_.is_open())
      file_ << text << std::endl;
    else
      so_far_ << text << '\n';
  }



  void
  Log::open_file(const std::string &name)
  {
    if (!speaks_)
      return;
    file_.open(name);
    file_ << so_far_.str() << std::flush;
    if (!file_)
      throw InputError(name + ": cannot be written, must be in a directory "
                              "with space and with the permission to write.");
  }



  std::string
  format(const char *pattern, ...)
  {
    std::va_list arguments, again;
    va_start(arguments, pattern);
    va_copy(again, arguments);
    std::string text(std::vsnprintf(nullptr, 0, pattern, arguments), ' ');
    std::vsnprintf(&text[0], text.size() + 1, pattern, again);
    va_end(arguments);
    va_end(again);
    return text;
  }
} // namespace stiction
