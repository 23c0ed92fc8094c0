// Rounding sets a floor to the residual, and every method reaches it: a
// tolerance of 1e-13 is met by all of them, and a run that asks for more than
// rounding allows (tolerance zero) ends at a feasible point and without a NaN,
// at the floor but for the two variants that release only when φ = o.
// Rounding does not make a normal force negative.

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/disc_active_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  const char *const names[] = {"DiscActiveSet as_printed",
                               "DiscActiveSet with_expansion",
                               "DiscActiveSet with_proportioning",
                               "DiscActiveSet with_projected_release",
                               "DiscActiveSet robust",
                               "DiscActiveSet spectral",
                               "Proportioning on half-lines",
                               "Proportioning on discs",
                               "Proportioning on half-lines times discs"};

  SolverRun solve(const int method, const MatrixXd &matrix, const VectorXd &radii,
                  const double tolerance, VectorXd &x, VectorXd &gradient)
  {
    const DenseOperator A(matrix);
    const Scaling scaling{VectorXd::Ones(radii.size()), 1.};
    const Discs discs(radii);
    if (method < 6)
      return DiscActiveSet(A, discs, 1., static_cast<DiscActiveSet::Variant>(method))
        .solve(x, gradient, scaling, tolerance, 3000);
    if (method == 6)
      return Proportioning(A, HalfLines(VectorXd::Zero(radii.size())), 1.)
        .solve(x, gradient, scaling, tolerance, 3000);
    if (method == 7)
      return Proportioning(A, discs, 1.).solve(x, gradient, scaling, tolerance, 3000);
    return Proportioning(A, HalfLinesTimesDiscs(radii), 1.)
      .solve(x, gradient, scaling, tolerance, 3000);
  }
} // namespace

int main()
{
  for (int method = 0; method < 9; ++method)
    {
      Random random(12);
      unsigned int not_converged = 0, not_finite = 0;
      Largest floor, outside;
      for (unsigned int sample = 0; sample < 40; ++sample)
        {
          const Index m = 1 + sample % 6;
          const Index n = method < 6 || method == 7 ? 2 * m : method == 6 ? m : 3 * m;
          const MatrixXd matrix = random.spd(n, 10.);
          const VectorXd b      = random.vector(n, -2., 3.);
          const VectorXd radii  = random.vector(m, 0.2, 2.);
          for (const double tolerance : {1e-13, 0.})
            {
              VectorXd x = VectorXd::Zero(n), gradient = -b;
              const SolverRun statistics =
                solve(method, matrix, radii, tolerance, x, gradient);
              if (tolerance > 0.)
                {
                  not_converged += !statistics.converged;
                  continue;
                }
              not_finite += !(x.allFinite() && gradient.allFinite());
              floor.add(statistics.residual);
              VectorXd projected = x;
              project(projected, n == 2 * m ? 0 : m, n == m ? VectorXd(0) : radii);
              outside.add((x - projected).norm());
            }
        }
      std::cout << names[method] << std::endl;
      print_count("  problems not solved to 1e-13", not_converged);
      print_count("  results with a NaN for tolerance zero", not_finite);
      if (method >= 2) // the first two wait for "φ = o", which may be never
        print_below("  their largest residual", floor, 1e-12);
      print_below("  their largest distance from the set", outside, 1e-14);
    }

  // Conjugate gradients go exactly to the end of the half-line here, where
  // rounding may carry them past it.
  {
    Random random(13);
    unsigned int negative = 0;
    for (unsigned int sample = 0; sample < 2000; ++sample)
      {
        const MatrixXd matrix = MatrixXd::Constant(1, 1, random.uniform(0.5, 1.));
        VectorXd x            = random.vector(1, 0., 1.);
        VectorXd gradient     = matrix * x; // the solution is x = 0
        solve(6, matrix, VectorXd::Ones(1), 1e-12, x, gradient);
        negative += !(x(0) >= 0.);
      }
    std::cout << "A contact that is about to open" << std::endl;
    print_count("  results below zero", negative);
  }
}
