#pragma once

#include "abaqus_keyword.h"

#include <stiction/base/text/text_scanner.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace stiction
{
  /// Where numbers and names of an Abaqus file count: within an instance, or a part that
  /// none puts anywhere, or outside of all.
  struct AbaqusScope
  {
    std::size_t number = 0; ///< 0 outside
    std::string prefix;     ///< of names: "LEFT-1.", empty outside
  };

  /// Elements as they are referred to somewhere: a number or the name of a set.
  struct AbaqusReference
  {
    std::string what;
    AbaqusScope scope;
    TextScanner::Place place; ///< behind it
  };

  /// An element by its number in a scope.
  struct AbaqusElement
  {
    std::size_t scope;
    std::int64_t number;
  };

  /// The sets of elements of an Abaqus file by their names, which are not case
  /// sensitive. What a set has may stand behind it, so that its members are known once
  /// all is read.
  class AbaqusSets
  {
  public:
    struct Set
    {
      AbaqusReference name; ///< where it begins, as it is written there
      std::vector<AbaqusElement> elements;
      std::vector<AbaqusReference> others; ///< sets that are in it, read or not
      bool has_cells = false;              ///< by '*ELEMENT, ELSET=name'
    };

    explicit AbaqusSets(TextScanner &text)
      : text_(text)
    {
    }

    /// That of an instance which begins here. Throws InputError if there is one of this
    /// name, or it has none.
    AbaqusScope add_scope(const std::string &instance);

    /// Throws InputError if there is none of this name.
    AbaqusScope scope_of(const std::string &instance) const;

    /// That of a name, which begins here if it is not there yet; stays where it is.
    Set &at(const AbaqusReference &name);

    /// Takes a line below "*ELSET", which has numbers and names of sets or, if they are
    /// generated, the first number, the last one and the step.
    ///
    /// @param scope that of the keyword, which may say "INSTANCE=" for its lines.
    ///
    /// Throws InputError if generated numbers are too many, or none.
    void add_line(Set &set, const AbaqusKeyword &keyword,
                  const std::vector<std::string> &items, const AbaqusScope &scope) const;

    /// In the order in which they begin.
    const std::vector<const Set *> &all() const { return in_order_; }

    /// The members of a set and of those in it, or the element of a number. Outside of
    /// instances "LEFT-1.all" and "LEFT-1.7" are those of one; where there is only one,
    /// "all" and "7" are, too. The file is behind the reference afterwards.
    ///
    /// Throws InputError if it is neither a set nor a number.
    std::vector<AbaqusElement> elements(const AbaqusReference &reference) const;

  private:
    const Set *find(const AbaqusScope &scope, const std::string &set) const;

    AbaqusElement element(const AbaqusReference &reference) const;

    TextScanner &text_;
    std::map<std::string, AbaqusScope> scopes_; // by names in capitals
    std::map<std::string, Set> sets_;           // by prefixes and names in such
    std::vector<const Set *> in_order_;
  };
} // namespace stiction
