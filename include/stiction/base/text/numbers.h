#pragma once

#include <optional>
#include <string>

namespace dealii
{
  class ParameterAcceptor;
}

namespace stiction
{
  /// Whether it is positive and not near the ends of the range of a double,
  /// where products would overflow; no unit system needs such numbers.
  bool is_sane(double value);

  /// What it must be then, for messages.
  inline const std::string sane_number = "a number > 0, from 1e-30 to 1e30";

  /// Whether one of the variables, letters, stands in a formula as a word.
  bool has_variable(const std::string &formula, const std::string &variables);

  /// Declares an entry of a section that is a number or empty: not said.
  void add_number(dealii::ParameterAcceptor &section, const std::string &name,
                  std::optional<double> &number, const std::string &documentation);
} // namespace stiction
