#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace stiction
{
  /// Writes a file, first beside its place and then renamed, so that nobody
  /// ever reads half of it. Not collective.
  ///
  /// Throws InputError if the file cannot be written in full.
  void write_file(const std::string &name,
                  const std::function<void(std::ostream &)> &write);

  /// The end of that, for a file that several ranks write: renames it or, if it
  /// was not written in full, removes it and throws InputError.
  void finish_file(const std::string &unfinished, const std::string &name,
                   bool is_written);

  /// Throws InputError that the file cannot be written, unless it was.
  void require_written(bool is_written, const std::string &name);

  /// Throws InputError, beginning with @p location, unless the directory can
  /// be written to or be made. Makes nothing. Not collective.
  void require_writable(const std::string &directory, const std::string &location);
} // namespace stiction
