#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace stiction
{
  /// The section 'Dual operator'.
  struct DualOperatorParameters : dealii::ParameterAcceptor
  {
    DualOperatorParameters();

    std::string form    = "assembled";
    bool symmetric_part = false; ///< of a problem from a file
  };
} // namespace stiction
