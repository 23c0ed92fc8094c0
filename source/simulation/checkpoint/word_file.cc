#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/simulation/checkpoint/word_file.h>

#include <deal.II/base/mpi.h>

#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>

namespace stiction::word_file
{
  namespace
  {
    // A word and its place, stirred (the finaliser of SplitMix64): sums of these are
    // checksums that can be added up in any order.
    std::uint64_t stirred(const std::uint64_t word, const std::uint64_t place)
    {
      std::uint64_t z = word ^ (0x9e3779b97f4a7c15U * (place + 1));
      z               = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
      z               = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
      return z ^ (z >> 31);
    }

    bool append(const std::string &name, const Words &words)
    {
      const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
      if (file < 0)
        return false;
      const char *at   = reinterpret_cast<const char *>(words.data());
      std::size_t left = sizeof(std::uint64_t) * words.size();
      while (left > 0)
        {
          const ssize_t n = ::write(file, at, left);
          if (n <= 0)
            break;
          at += n;
          left -= static_cast<std::size_t>(n);
        }
      const bool is_safe = left == 0 && ::fsync(file) == 0;
      return ::close(file) == 0 && is_safe;
    }
  } // namespace

  Digest write(const std::string &name, const Words &words, MPI_Comm communicator)
  {
    const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n    = dealii::Utilities::MPI::n_mpi_processes(communicator);
    for (unsigned int r = 0; r < n; ++r)
      throw_on_all_ranks(
        communicator, [&]() { require_written(r != rank || append(name, words), name); });
    const std::uint64_t size = words.size();
    std::uint64_t first      = 0;
    MPI_Exscan(&size, &first, 1, MPI_UINT64_T, MPI_SUM, communicator);
    if (rank == 0)
      first = 0; // which MPI leaves undefined
    Digest mine{size, 0};
    for (std::uint64_t k = 0; k < size; ++k)
      mine.checksum += stirred(words[k], first + k);
    Digest all;
    MPI_Allreduce(&mine, &all, 2, MPI_UINT64_T, MPI_SUM, communicator);
    return all;
  }

  Words read(const std::string &name, const std::uint64_t first, const std::uint64_t n)
  {
    Words words(n);
    std::ifstream in(name, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(sizeof(std::uint64_t) * first));
    in.read(reinterpret_cast<char *>(words.data()),
            static_cast<std::streamsize>(sizeof(std::uint64_t) * n));
    if (!in)
      throw InputError(name + ": cannot be read, must be the file that was written.");
    return words;
  }

  Digest digest(const std::string &name)
  {
    std::ifstream in(name, std::ios::binary);
    Digest all;
    Words words(1 << 16);
    while (in)
      {
        in.read(reinterpret_cast<char *>(words.data()),
                static_cast<std::streamsize>(sizeof(std::uint64_t) * words.size()));
        const auto n = static_cast<std::size_t>(in.gcount());
        for (std::size_t k = 0; k < n / sizeof(std::uint64_t); ++k)
          all.checksum += stirred(words[k], all.n_words++);
        if (n % sizeof(std::uint64_t) != 0) // mesh files may end anywhere
          {
            std::uint64_t rest = 0;
            std::memcpy(&rest, &words[n / sizeof(std::uint64_t)],
                        n % sizeof(std::uint64_t));
            all.checksum += stirred(rest, all.n_words++);
          }
      }
    return all;
  }

  Words of_numbers(const std::vector<double> &numbers)
  {
    Words words(numbers.size());
    std::memcpy(words.data(), numbers.data(), sizeof(double) * numbers.size());
    return words;
  }

  std::vector<double> to_numbers(const Words &words)
  {
    std::vector<double> numbers(words.size());
    std::memcpy(numbers.data(), words.data(), sizeof(double) * words.size());
    return numbers;
  }
} // namespace stiction::word_file
