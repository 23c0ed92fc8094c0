#pragma once

#include <stiction/qp/methods/dual_method.h>

#include <memory>

namespace stiction
{
  class DualOperator;
  struct ContactSolverParameters;

  /// The method chosen in the parameter file, for the operator, which must
  /// outlive it; newton, which it hands over to, for 'newton multigrid'.
  ///
  /// @param coulomb whether the problem is one of Coulomb friction: a method
  ///   for given friction is then put into successive approximations, and so
  ///   is any other if the file asks for them.
  std::unique_ptr<DualMethod> create_dual_method(
    const ContactSolverParameters &parameters, const DualOperator &Q, bool coulomb);

  /// The compliance of the springs by which an augmented Lagrangian presses
  /// obstacles on, over that of the body, that is best for the chosen method. The
  /// larger it is, the fewer solves and the worse conditioned the operator: admm
  /// has to add up the gaps of open nodes in steps.
  double best_spring_compliance(const ContactSolverParameters &parameters);

  /// The weight of the balance of a body with free motions in the method of multipliers,
  /// over the norm of its dual operator: the larger, the fewer its updates, and the
  /// slower methods that alternate between normal and tangential forces.
  double best_balance_weight(const ContactSolverParameters &parameters);
} // namespace stiction
