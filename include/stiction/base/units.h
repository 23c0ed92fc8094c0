#pragma once

#include <string>

namespace stiction
{
  /// The names of the units that the numbers of a run have, as the user said
  /// them in 'Output/Units'. They are labels alone: any consistent system
  /// gives the same answer, nothing is converted, and where none was said
  /// every name is empty.
  struct Units
  {
    std::string length, area, force, moment, stress, energy, density;

    /// @param name one of choices().
    static Units named(const std::string &name);

    /// The choices of the entry as deal.II's Patterns::Selection wants them.
    static const char *choices();
  };

  /// "largest pressure [Pa]", or the quantity alone where its unit is not
  /// known.
  std::string label(const std::string &quantity, const std::string &unit);

  /// "0.3 mm", or the number alone.
  std::string with_unit(const std::string &number, const std::string &unit);
} // namespace stiction
