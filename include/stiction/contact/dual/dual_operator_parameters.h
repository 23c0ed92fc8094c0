#ifndef stiction_contact_dual_dual_operator_parameters_h
#define stiction_contact_dual_dual_operator_parameters_h

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

#endif
