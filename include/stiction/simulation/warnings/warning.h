#pragma once

#include <string>
#include <vector>

namespace stiction
{
  /// What a user should know of a step that its certificate does not tell.
  struct Warning
  {
    std::string about; ///< what, "slide of pad.bottom", once a step
    double size;       ///< of several steps the worst one has the largest
    std::string text;  ///< a sentence
  };

  /// Of the largest force at a node, of a boundary or a body: less bears nothing.
  constexpr double no_force = 1e-6;

  using Warnings = std::vector<Warning>;
} // namespace stiction
