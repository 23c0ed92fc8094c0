#include <stiction/simulation/parameters/performance_parameters.h>

namespace stiction
{
  PerformanceParameters::PerformanceParameters()
    : ParameterAcceptor("Performance")
  {
    add_parameter("Measure one elastic solve", measure_one_elastic_solve,
                  "Also solve the body without contact by conjugate gradients with the "
                  "multigrid of the run (algebraic where there is none), twice, and "
                  "state the price of the contact solve in such solves.");
    add_parameter("Measure factorizations", measure_factorizations,
                  "Also factorise the stiffness matrix (sparse) and the "
                  "assembled dual operator (dense) once more by themselves and "
                  "state the times: units for the cost of the contact solve.");
    add_parameter("Print timing", print_timing,
                  "Whether times and iteration counts are printed at the end. "
                  "summary.json has them in any case.");
  }
} // namespace stiction
