#pragma once

#include <exception>

namespace stiction
{
  /// Thrown on all ranks after a step that is to be the last one.
  class Interrupted : public std::exception
  {
  public:
    const char *what() const noexcept override { return "interrupted"; }
  };
} // namespace stiction
