#include <stiction/contact/dual/dual_operator_parameters.h>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  DualOperatorParameters::DualOperatorParameters()
    : ParameterAcceptor("Dual operator")
  {
    add_parameter("Form", form,
                  "How the dual Hessian Q is held. assembled: as a dense "
                  "matrix of three rows a contact node; by solves: one elastic "
                  "solve a product, no storage.",
                  prm, Patterns::Selection("assembled|by solves"));
    add_parameter("Symmetric part", symmetric_part,
                  "Of a problem from a file (--problem) alone, whose Q is refused where "
                  "it is not symmetric to 1e-8 of its diagonal. true: its symmetric "
                  "part, (Q + Q^T)/2, is taken in its place, which is another problem; "
                  "how far Q is from it is said with the certificate.");
  }
} // namespace stiction
