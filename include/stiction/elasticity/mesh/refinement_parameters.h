#pragma once

#include <deal.II/base/parameter_acceptor.h>

namespace stiction
{
  class ParameterFile;

  /// The section 'Refinement'.
  struct RefinementParameters : dealii::ParameterAcceptor
  {
    RefinementParameters();

    /// Throws InputError about what a pattern cannot see.
    void check(const ParameterFile &source) const;

    unsigned int adaptive_steps   = 0;
    double fraction               = 0.5;
    double wanted_error           = 0.;
    unsigned int maximum_unknowns = 0;
    bool estimate_error           = true;
  };
} // namespace stiction
