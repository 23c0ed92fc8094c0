#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace stiction
{
  /// The section 'Stiffness solver'.
  struct StiffnessSolverParameters : dealii::ParameterAcceptor
  {
    StiffnessSolverParameters();

    std::string type = "automatic";
  };
} // namespace stiction
