#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/base/log.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <iostream>

namespace stiction
{
  Log::Log(MPI_Comm communicator)
    : communicator_(communicator)
    , speaks_(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    , last_line_(std::chrono::steady_clock::now())
  {
  }

  void Log::line(const std::string &text)
  {
    if (!speaks_)
      return;
    const std::lock_guard<std::mutex> lock(mutex_);
    last_line_ = std::chrono::steady_clock::now();
    std::cout << text << std::endl;
    if (file_.is_open())
      file_ << text << std::endl;
    else
      so_far_ << text << '\n';
  }

  void Log::open_file(const std::string &name, const bool appends)
  {
    if (!speaks_)
      return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!directory_lock_.acquire(std::filesystem::path(name).parent_path()))
      throw InputError(name + ": another run is writing beside it, wait until it ends or "
                              "choose another directory.");
    const std::string so_far = so_far_.str();
    if (!appends) // the earlier one is whole until this one is
      write_file(name, [&](std::ostream &out) { out << so_far; });
    file_name_ = name;
    file_.open(name, std::ios::app);
    if (appends)
      file_ << so_far << std::flush;
    require_written(file_.good(), name);
  }

  void Log::close_file()
  {
    do_on_first_rank(communicator_, [&]() {
      const std::lock_guard<std::mutex> lock(mutex_);
      std::error_code error;
      if (!std::filesystem::exists(file_name_, error))
        throw InputError(file_name_ + ": was removed or hidden while the run was on, "
                                      "must stay until it ends.");
      file_.close();
      require_written(file_.good(), file_name_);
    });
    directory_lock_.release();
  }

  double Log::seconds_of_silence() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - last_line_)
      .count();
  }

  std::string format(const char *pattern, ...)
  {
    std::va_list arguments, again;
    va_start(arguments, pattern);
    va_copy(again, arguments);
    std::string text(std::vsnprintf(nullptr, 0, pattern, arguments), ' ');
    std::vsnprintf(text.data(), text.size() + 1, pattern, again);
    va_end(arguments);
    va_end(again);
    return text;
  }

  std::array<double, 3> without_rounding(std::array<double, 3> v, const double size)
  {
    const double norm = std::max(size, std::hypot(v[0], v[1], v[2]));
    for (double &component : v)
      if (std::abs(component) <= 1e-12 * norm)
        component = 0.;
    return v;
  }
} // namespace stiction
