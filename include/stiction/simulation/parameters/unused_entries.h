#pragma once

#include <string>
#include <vector>

namespace stiction
{
  class Parameters;

  /// Entries that the file or the settings give and that nothing makes use of, with the
  /// reason: "brick.prm, line 12: Friction/Coefficient: no 'Law' is 'coulomb'".
  std::vector<std::string> unused_entries(const Parameters &parameters);
} // namespace stiction
