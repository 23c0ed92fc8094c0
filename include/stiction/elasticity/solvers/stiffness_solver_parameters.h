#ifndef stiction_elasticity_solvers_stiffness_solver_parameters_h
#define stiction_elasticity_solvers_stiffness_solver_parameters_h

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

#endif
