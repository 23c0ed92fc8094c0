#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace stiction
{
  /// The section 'Contact solver'.
  struct ContactSolverParameters : dealii::ParameterAcceptor
  {
    ContactSolverParameters();

    /// Whether the method solves for displacements, not for contact forces.
    bool is_primal() const;

    std::string method              = "automatic";
    bool is_automatic               = false; ///< once that was replaced by a method
    double tolerance                = 1e-6;
    unsigned int maximum_iterations = 1000;
    std::string disc_solver         = "newton";
    unsigned int squares            = 2;
    std::string coulomb_iteration   = "direct";
  };
} // namespace stiction
