#include <stiction/base/errors.h>
#include <stiction/base/files.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace stiction
{
  void write_file(const std::string &name,
                  const std::function<void(std::ostream &)> &write)
  {
    const std::string unfinished = name + ".new";
    std::ofstream out(unfinished);
    try
      {
        if (out)
          write(out);
      }
    catch (const dealii::ExceptionBase &)
      {
        out.setstate(std::ios::failbit); // deal.II met the failing stream
      }
    out.close();
    finish_file(unfinished, name, out.good());
  }

  void finish_file(const std::string &unfinished, const std::string &name,
                   const bool is_written)
  {
    std::error_code error, none;
    if (is_written)
      std::filesystem::rename(unfinished, name, error);
    if (!is_written || error)
      {
        std::filesystem::remove(unfinished, none);
        require_written(false, name);
      }
  }

  void require_written(const bool is_written, const std::string &name)
  {
    if (!is_written)
      throw InputError(name + ": cannot be written, must be in a directory with "
                              "space and with the permission to write.");
  }

  void require_writable(const std::string &directory, const std::string &location)
  {
    namespace fs = std::filesystem;
    std::error_code error;
    fs::path existing = fs::absolute(directory, error);
    while (!error && !fs::exists(existing, error) && existing.has_relative_path())
      {
        if (error == std::errc::no_such_file_or_directory)
          error.clear();
        existing = existing.parent_path();
      }
    if (error || !fs::is_directory(existing, error) ||
        ::access(existing.c_str(), W_OK | X_OK) != 0)
      throw InputError(location + ", cannot be written to, must be a directory that "
                                  "exists or can be made.");
  }
} // namespace stiction
