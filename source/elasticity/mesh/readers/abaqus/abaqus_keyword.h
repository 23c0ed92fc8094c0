#pragma once

#include <stiction/base/text/text_scanner.h>

#include <map>
#include <string>
#include <vector>

namespace stiction
{
  /// What stands between the commas of a line of an Abaqus file, without quotes.
  std::vector<std::string> abaqus_items(const std::string &line);

  /// A line of an Abaqus file that begins with a star: "*ELEMENT, TYPE=C3D8".
  struct AbaqusKeyword
  {
    /// Whether a line is one, and no comment.
    static bool begins(const std::string &line)
    {
      return line.rfind('*', 0) == 0 && line.rfind("**", 0) != 0;
    }

    AbaqusKeyword() = default;

    /// @param line goes on in the next one of the text if it ends with a comma.
    AbaqusKeyword(std::string line, TextScanner &text);

    bool has(const std::string &option) const { return options.count(option) != 0; }

    /// The value of an option, empty if it has none or is not there.
    std::string value(const std::string &option) const;

    /// What it says of the problem beside its mesh, as people write it: "*CONTACT PAIR";
    /// empty: nothing.
    std::string of_the_problem() const;

    /// Refuses a keyword without whose data, which are not in the file, the mesh would be
    /// another one.
    void require_all_is_here(const TextScanner &text) const;

    /// What to say if it is a misspelt keyword of meshes, as a clause that begins with
    /// the line; empty: it is none.
    std::string misspelt(const TextScanner &text) const;

    std::string name; ///< in capital letters with the star, without blanks: "*ENDPART"
    /// Names in capital letters, values as they are written.
    std::map<std::string, std::string> options;
  };

  /// Passes over all up to this keyword.
  void skip_to(const std::string &last, TextScanner &text);
} // namespace stiction
