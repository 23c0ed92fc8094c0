#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace stiction
{
  /// The subsections 'Contact pair NAME' of a parameter file, each of which says all
  /// of one contact boundary. They are another way to write the lists 'a | b' of the
  /// sections 'Boundary conditions' and 'Friction'.
  class ContactPairs
  {
  public:
    /// Whether a section is a pair, by its name.
    static bool is_pair(const std::string &section);

    /// NAME of the section 'Contact pair NAME'; "" of others.
    static std::string name_of(const std::string &section);

    /// @param where the beginning of a sentence about the place.
    ///
    /// Throws InputError if a pair of this name was begun before.
    void begin(const std::string &where, const std::string &pair);

    /// Throws InputError for a pair that was not begun, an entry that pairs do not
    /// have, and a value with a bar.
    void set(const std::string &where, const std::string &pair, const std::string &entry,
             const std::string &value);

    /// A value of one pair: "line 7", "Contact pair floor/Coefficient", "0.3"; no place
    /// if the pair does not say it.
    struct OfPair
    {
      std::string where, entry, value;
    };

    /// One of the lists: "Friction", "Coefficient", "0.3 | 0.1", and where its values
    /// stand.
    struct List
    {
      std::string where, section, name, value;
      std::vector<OfPair> of_pairs;
    };

    /// All lists, none if there are no pairs. What no pair says has no place; what
    /// one of several says not has its default.
    ///
    /// @param default_of that of "Section/Entry".
    ///
    /// Throws InputError for a pair without a boundary.
    std::vector<List> lists(
      const std::function<std::string(const std::string &entry)> &default_of) const;

  private:
    struct Place
    {
      std::string where, value;
    };

    struct Pair
    {
      std::string where, name;
      std::map<std::string, Place> entries;
    };

    std::vector<Pair> pairs_;
  };
} // namespace stiction
