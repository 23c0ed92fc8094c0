#pragma once

#include <deal.II/base/parameter_acceptor.h>

namespace stiction
{
  /// The section 'Performance'.
  struct PerformanceParameters : dealii::ParameterAcceptor
  {
    PerformanceParameters();

    bool measure_one_elastic_solve = false;
    bool measure_factorizations    = false;
    bool print_timing              = true;
  };
} // namespace stiction
