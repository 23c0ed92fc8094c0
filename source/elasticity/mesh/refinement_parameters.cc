#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/mesh/refinement_parameters.h>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  RefinementParameters::RefinementParameters()
    : ParameterAcceptor("Refinement")
  {
    add_parameter("Adaptive steps", adaptive_steps,
                  "How many times the mesh is refined where the solution needs it: the "
                  "problem is solved and certified, the error is estimated cell by cell "
                  "(in the energy norm, from what the stress lacks to be in equilibrium "
                  "inside the cells, across their faces and with the loads and contact "
                  "forces), the cells with the largest errors are cut into eight, and "
                  "the problem is solved again. The files are those of the last mesh; it "
                  "is the last one too if its answer is not certified. In every step of "
                  "a history so many times again, from the mesh of the step before, "
                  "which is not made coarser: 'Wanted error' or 'Maximum unknowns' end "
                  "that.",
                  prm, Patterns::Integer(0, 50));
    add_parameter("Fraction", fraction,
                  "The cells that are cut are the fewest that make up this part of the "
                  "sum of the squares of the estimated errors; above 0, at most 1.",
                  prm, Patterns::Double());
    add_parameter("Wanted error", wanted_error,
                  "No cell is cut where the estimated error, as a part of the energy "
                  "norm of the displacement, is at most this: 0.05 for 5 %. 0: none.",
                  prm, Patterns::Double(0., 1.));
    add_parameter("Maximum unknowns", maximum_unknowns,
                  "No mesh is made that would have more unknowns than about "
                  "this; 0: the memory is the limit.",
                  prm, Patterns::Integer(0));
    add_parameter("Estimate error", estimate_error,
                  "Whether the last lines of a run say how large the error of the mesh "
                  "is, as a part of the energy norm of the displacement: an estimate, no "
                  "bound. Above 16384 cells it is made from a sample of them. Adaptive "
                  "steps estimate it in any case.");
  }

  void RefinementParameters::check(const ParameterFile &source) const
  {
    source.require(fraction > 0. && fraction <= 1., "Refinement/Fraction",
                   "must be above 0 and at most 1");
  }
} // namespace stiction
