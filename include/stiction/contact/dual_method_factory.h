#ifndef stiction_contact_dual_method_factory_h
#define stiction_contact_dual_method_factory_h

#include <stiction/contact/dual_method.h>

#include <memory>

namespace stiction
{
  class DualOperator;
  struct ContactSolverParameters;

  /// The method chosen in the parameter file, for the operator, which must
  /// outlive it.
  ///
  /// @param coulomb whether the problem is one of Coulomb friction: a method
  ///   for given friction is then put into successive approximations, and so
  ///   is any other if the file asks for them.
  std::unique_ptr<DualMethod>
  create_dual_method(const ContactSolverParameters &parameters,
                     const DualOperator &Q,
                     bool coulomb);
} // namespace stiction

#endif
