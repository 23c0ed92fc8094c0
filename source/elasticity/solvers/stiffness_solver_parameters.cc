#include <stiction/elasticity/solvers/stiffness_solver_parameters.h>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  StiffnessSolverParameters::StiffnessSolverParameters()
    : ParameterAcceptor("Stiffness solver")
  {
    add_parameter(
      "Type", type,
      "How systems with the stiffness matrix are solved. mumps: one sparse "
      "factorisation, then cheap solves; multigrid: conjugate gradients with geometric "
      "multigrid on the levels of 'Geometry/Global refinement' and grids behind the "
      "coarsest, without a matrix, for large bodies; amg: with algebraic multigrid on "
      "the matrix. automatic: multigrid for 'Contact solver/Method = newton multigrid', "
      "otherwise mumps.",
      prm, Patterns::Selection("automatic|mumps|amg|multigrid"));
  }
} // namespace stiction
