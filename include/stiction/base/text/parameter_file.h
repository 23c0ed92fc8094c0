#pragma once

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace stiction
{
  class ContactPairs;

  /// Reads a parameter file and command line settings into a ParameterHandler
  /// that knows what is allowed, and remembers where each value came from.
  ///
  /// deal.II's own reader stops at the same faults, but with messages of many
  /// lines that do not say what is allowed; this one finds them first.
  class ParameterFile
  {
  public:
    /// An unread file: everything has its default.
    ParameterFile() = default;

    /// The sections of a file that begin with this word and go on with a name, each
    /// once, in its order; none of a file that cannot be read.
    static std::vector<std::string> sections(const std::string &file,
                                             const std::string &word);

    /// Reads @p file (nothing if that is empty), then applies each of @p
    /// settings ("Section/Entry=value") in the order given. Sections 'Contact pair
    /// NAME' become the lists of 'Boundary conditions' and 'Friction'.
    ///
    /// Throws InputError naming file, line, entry, value and what is allowed,
    /// for a file that cannot be read, an unknown section or entry, a value
    /// that does not match, or a line that is no statement.
    void read(const std::string &file, const std::vector<std::string> &settings,
              dealii::ParameterHandler &prm);

    /// Gives one entry a value.
    ///
    /// @param where the beginning of a sentence about where the value stands.
    ///
    /// Throws as read().
    void assign(const std::string &where, const std::string &section,
                const std::string &name, const std::string &value,
                dealii::ParameterHandler &prm);

    /// "brick.prm, line 12: Material/Poisson ratio = 0.7": the beginning of a
    /// sentence about the value of @p entry ("Section/Entry").
    std::string describe(const std::string &entry) const;

    /// The file as far as it speaks of one contact boundary: entries of its section
    /// 'Contact pair NAME' have their own places, names and values.
    ParameterFile of_pair(std::size_t number) const;

    /// The section where an entry of a contact boundary belongs: 'Contact pair NAME', or
    /// that of the lists if the file has no such sections.
    std::string section_of_pair(const std::string &entry, std::size_t number) const;

    /// "brick.prm, line 12: Material/Poisson ratio", for values that are too
    /// long to repeat.
    std::string locate(const std::string &entry) const;

    /// "brick.prm: Material/Density is not set": the beginning of a sentence
    /// about an entry that is empty.
    std::string describe_missing(const std::string &entry) const;

    /// Throws InputError about the value of the entry, "..., must be positive.".
    [[noreturn]] void refuse(const std::string &entry, const std::string &allowed) const;

    /// Does so unless the condition holds.
    void require(bool condition, const std::string &entry,
                 const std::string &allowed) const;

    /// The path of a file that @p entry names: beside the parameter file or, if there is
    /// none, from the working directory, which goes first for what --set gives.
    ///
    /// Throws InputError, naming both places, if there is none.
    std::string find_file(const std::string &entry, const std::string &name) const;

    /// The name of the parameter file.
    const std::string &file() const { return file_; }

    /// The values that the file and the settings give, by entry
    /// ("Section/Entry"), or with the defaults those of all entries.
    std::map<std::string, std::string> given(bool or_default = false) const;

  private:
    /// Gives an entry of a section or of a contact pair a value.
    void give(const std::string &where, const std::string &section,
              const std::string &name, const std::string &value, ContactPairs &pairs,
              dealii::ParameterHandler &prm);

    /// Does so as --set has it, "Section/Entry=value".
    void give(const std::string &setting, ContactPairs &pairs,
              dealii::ParameterHandler &prm);

    /// Gives the lists of the contact boundaries what the contact pairs say. Throws
    /// InputError if the file says both.
    void assign_lists(const ContactPairs &pairs, dealii::ParameterHandler &prm);

    struct Place
    {
      std::string where;
      std::string value;
      std::string name = {}; ///< what the entry is called there, if not as here
    };

    std::string file_;
    /// All sections and entries, with what is allowed.
    std::shared_ptr<const nlohmann::ordered_json> declared_;
    std::map<std::string, Place> places_;
    /// Of the lists that the sections 'Contact pair' say, the places of each pair.
    std::map<std::string, std::vector<Place>> of_pairs_;
  };
} // namespace stiction
