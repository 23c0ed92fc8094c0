#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/simulation/checkpoint/checkpoint_files.h>
#include <stiction/simulation/checkpoint/word_file.h>

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace stiction::checkpoint_files
{
  namespace fs = std::filesystem;
  using nlohmann::json;

  namespace
  {
    // Raised whenever an older program could not read what this one writes.
    constexpr int current_format = 3;

    const std::string last_name       = "/checkpoint";
    const std::string old_name        = "/checkpoint.old";
    const std::string unfinished_name = "/checkpoint.new";

    const std::string header_name = "/checkpoint.json";
    const std::string digest_name = "/checkpoint.digest"; // of the header

    std::string digest_of(const std::string &file)
    {
      const auto digest = word_file::digest(file);
      return json{digest.n_words, digest.checksum}.dump();
    }

    // Waits until the disk has what was written to a file or done in a directory.
    void flush(const std::string &name)
    {
      const int file = ::open(name.c_str(), O_RDONLY);
      if (file < 0)
        return;
      ::fsync(file); // what cannot do it, a network, does without
      ::close(file);
    }

    // Throws InputError about a file that is not what was written.
    void require_intact(const std::string &checkpoint, const json &header)
    {
      for (const auto &file : header.at("files").items())
        {
          const std::string name = checkpoint + "/" + file.key();
          const auto digest      = word_file::digest(name);
          if (json{digest.n_words, digest.checksum} != file.value())
            throw InputError(name + ": is cut off or damaged, must be the file that was "
                                    "written");
        }
    }

    // Throws InputError without looking for another one.
    json readable_header(const std::string &checkpoint)
    {
      try
        {
          std::ifstream in(checkpoint + header_name);
          json header = json::parse(in);
          std::string digest;
          std::getline(std::ifstream(checkpoint + digest_name), digest);
          if (header.at("format") != current_format)
            throw InputError(checkpoint + ": was written by " +
                             header.at("program").get<std::string>() + " in format " +
                             header["format"].dump() + ", must be of format " +
                             std::to_string(current_format));
          require_intact(checkpoint, header);
          if (digest == digest_of(checkpoint + header_name))
            return header;
        }
      catch (const InputError &)
        {
          throw;
        }
      catch (const std::exception &) // of what is no JSON, no file, or lacks something
        {
        }
      throw InputError(checkpoint + ": is damaged or no checkpoint, must be one that "
                                    "'Time/Checkpoint every' had written");
    }

    bool is_readable(const std::string &checkpoint)
    {
      try
        {
          readable_header(checkpoint);
          return true;
        }
      catch (const InputError &)
        {
          return false;
        }
    }
  } // namespace

  std::string begin(const std::string &directory, MPI_Comm communicator)
  {
    std::string name = directory + unfinished_name;
    do_on_first_rank(communicator, [&]() {
      std::error_code error;
      fs::remove_all(name, error);
      require_written(!error, name);
      fs::create_directory(name, error);
      require_written(!error, name);
    });
    return name;
  }

  void finish(const std::string &directory, json header)
  {
    const std::string unfinished = directory + unfinished_name;
    header["format"]             = current_format;
    header["program"]            = std::string("stiction ") + STICTION_VERSION;
    write_file(unfinished + header_name, [&](std::ostream &out) {
      out << header.dump(1, ' ', false, json::error_handler_t::replace) << '\n';
    });
    write_file(unfinished + digest_name, [&](std::ostream &out) {
      out << digest_of(unfinished + header_name) << '\n';
    });
    flush(unfinished + header_name);
    flush(unfinished + digest_name);
    flush(unfinished);

    const std::string last = directory + last_name, old = directory + old_name;
    std::error_code error;
    if (fs::exists(last, error))
      {
        fs::remove_all(old, error);
        require_written(!error, old);
        fs::rename(last, old, error);
        require_written(!error, old);
      }
    fs::rename(unfinished, last, error);
    require_written(!error, last);
    flush(directory);
  }

  std::string find(const std::string &directory)
  {
    std::error_code error;
    if (fs::exists(directory + header_name, error))
      return directory;
    // a run killed between two renames leaves the old one alone
    for (const std::string &checkpoint : {directory + last_name, directory + old_name})
      if (fs::is_directory(checkpoint, error))
        return checkpoint;
    throw InputError("--restart " + directory +
                     ": has no checkpoint, must be the output directory of a run with "
                     "'Time/Checkpoint every' above 0.");
  }

  json header(const std::string &checkpoint)
  {
    try
      {
        return readable_header(checkpoint);
      }
    catch (const InputError &fault)
      {
        const std::string before = checkpoint + ".old";
        throw InputError(fault.what() +
                         (is_readable(before)
                            ? "; the one before can be read: --restart " + before + "."
                            : std::string(".")));
      }
  }

  void remove(const std::string &directory)
  {
    std::error_code error; // what cannot be removed cannot be replaced either
    for (const std::string &checkpoint :
         {directory + last_name, directory + old_name, directory + unfinished_name})
      fs::remove_all(checkpoint, error);
  }
} // namespace stiction::checkpoint_files
