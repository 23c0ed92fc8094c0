#pragma once

#include <string>

namespace stiction
{
  /// Keeps other runs out of a directory, as long as they ask. The system ends it
  /// with the process, however that ends.
  class DirectoryLock
  {
  public:
    DirectoryLock()                                 = default;
    DirectoryLock(const DirectoryLock &)            = delete;
    DirectoryLock &operator=(const DirectoryLock &) = delete;
    ~DirectoryLock() { release(); }

    /// @return false if another one has it. File systems that know no locks keep
    ///   nobody out.
    bool acquire(const std::string &directory);

    void release();

  private:
    int file_ = -1;
  };
} // namespace stiction
