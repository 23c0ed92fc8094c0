#include <stiction/base/directory_lock.h>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace stiction
{
  bool DirectoryLock::acquire(const std::string &directory)
  {
    release();
    file_ = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    return file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  }

  void DirectoryLock::release()
  {
    if (file_ >= 0)
      ::close(file_);
    file_ = -1;
  }
} // namespace stiction
