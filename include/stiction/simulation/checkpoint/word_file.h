#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mpi.h>

/// Words of 64 bits in a file: whole numbers, or floating point numbers bit by bit.
namespace stiction::word_file
{
  using Words = std::vector<std::uint64_t>;

  /// What a file has, by which one that is cut off or damaged is known.
  struct Digest
  {
    std::uint64_t n_words = 0, checksum = 0;
  };

  /// Writes a file of the words of all ranks, one rank after the other, and waits
  /// until the disk has them. Collective. Throws InputError if that fails.
  Digest write(const std::string &name, const Words &words, MPI_Comm communicator);

  /// Reads so many words from the first one on. Not collective. Throws InputError
  /// if they are not there.
  Words read(const std::string &name, std::uint64_t first, std::uint64_t n);

  /// Of a whole file, of no words if there is none. Not collective.
  Digest digest(const std::string &name);

  Words of_numbers(const std::vector<double> &numbers);
  std::vector<double> to_numbers(const Words &words);
} // namespace stiction::word_file
