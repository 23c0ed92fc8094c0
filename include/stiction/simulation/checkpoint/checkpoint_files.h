#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

#include <mpi.h>

/// The directories 'checkpoint' and 'checkpoint.old' in an output directory: how
/// they come to be, and whether they are in order.
namespace stiction::checkpoint_files
{
  /// Makes an empty directory for the files of the next checkpoint. Collective.
  /// @return its name. Throws InputError if it cannot be made.
  std::string begin(const std::string &directory, MPI_Comm communicator);

  /// Writes the header, in which "files" says what each file has, and gives the
  /// directory its name. Not collective. Throws InputError.
  void finish(const std::string &directory, nlohmann::json header);

  /// The checkpoint to take of an output directory, or the directory itself if it
  /// is one. Not collective. Throws InputError if there is none.
  std::string find(const std::string &directory);

  /// The header of a checkpoint all of whose files are what they were. Not
  /// collective. Throws InputError.
  nlohmann::json header(const std::string &checkpoint);

  /// Removes the checkpoints of an earlier run. Not collective.
  void remove(const std::string &directory);
} // namespace stiction::checkpoint_files
