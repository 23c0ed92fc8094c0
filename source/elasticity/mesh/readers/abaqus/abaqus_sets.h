#pragma once

#include <stiction/base/text/text_scanner.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
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

  /// An element by its number in a scope.
  struct AbaqusElement
  {
    std::size_t scope;
    std::int64_t number;

    bool operator<(const AbaqusElement &other) const
    {
      return std::pair(scope, number) < std::pair(other.scope, other.number);
    }
  };

  /// The numbers of a line below '*ELSET, GENERATE': the first, the last and the step.
  /// Throws InputError if they are too many, or none.
  std::vector<std::int64_t> generated_numbers(const std::vector<std::string> &items,
                                              const TextScanner &text);

  /// The sets of elements of an Abaqus file by their names, which are not case
  /// sensitive. Whatever it refuses, it does so with the line that the file is at.
  class AbaqusSets
  {
  public:
    explicit AbaqusSets(const TextScanner &text)
      : text_(text)
    {
    }

    /// That of an instance which begins here. Throws InputError if there is one of this
    /// name, or it has none.
    AbaqusScope add_scope(const std::string &instance);

    /// Throws InputError if there is none of this name.
    AbaqusScope scope_of(const std::string &instance) const;

    void add(const AbaqusScope &scope, const std::string &set,
             const AbaqusElement &element);

    /// The members of a set, or the element of a number. Outside of instances
    /// "LEFT-1.all" and "LEFT-1.7" are those of one; where there is only one, "all" and
    /// "7" are, too.
    ///
    /// Throws InputError if it is neither a set nor a number.
    std::vector<AbaqusElement> elements(const AbaqusScope &scope,
                                        const std::string &what) const;

  private:
    const std::vector<AbaqusElement> *find(const AbaqusScope &scope,
                                           const std::string &set) const;

    const TextScanner &text_;
    std::map<std::string, AbaqusScope> scopes_;              // by names in capitals
    std::map<std::string, std::vector<AbaqusElement>> sets_; // by prefix and name in such
  };
} // namespace stiction
