// A singular Hessian is no obstacle where the set is bounded: along a free
// direction without curvature the method goes to the boundary, and it reaches
// the least energy. The projected gradient method is the reference; points of
// least energy are not unique, their energy is, and so is Ax.

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/disc_active_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  SolverRun solve(const int method, const MatrixXd &matrix, const VectorXd &radii,
                  VectorXd &x, VectorXd &r, const unsigned int max = 5000)
  {
    const DenseOperator A(matrix);
    const Discs discs(radii);
    const Scaling scaling{VectorXd::Ones(radii.size()), 1.};
    if (method < 6)
      return DiscActiveSet(A, discs, 1., static_cast<DiscActiveSet::Variant>(method))
        .solve(x, r, scaling, 1e-9, max);
    return Proportioning(A, discs, 1.).solve(x, r, scaling, 1e-9, max);
  }
} // namespace

int main()
{
  // ------------------------------- no curvature at all: −b·x on one disc
  unsigned int not_exact = 0;
  for (int method = 0; method < 7; ++method)
    {
      const MatrixXd zero = MatrixXd::Zero(2, 2);
      VectorXd x          = VectorXd::Zero(2), b(2);
      b << 3., 4.;
      VectorXd r = -b;
      const SolverRun statistics =
        solve(method, zero, VectorXd::Constant(1, 10.), x, r, 1);
      not_exact += !(statistics.converged && statistics.expansion_steps == 1 &&
                     (x - 2. * b).norm() < 1e-14);
    }
  std::cout << "A = 0 on a disc" << std::endl;
  print_count("  methods that miss the solution in one step", not_exact);

  // -------------- half of the eigenvalues are zero, and b may have a part
  // there
  Random random(22);
  unsigned int not_converged = 0, inside = 0, on_circle = 0;
  Largest above, distance;
  for (unsigned int sample = 0; sample < 40; ++sample)
    {
      const Index m   = 1 + sample % 4;
      VectorXd values = random.vector(2 * m, 0.2, 1.);
      values.head(m).setZero();
      const MatrixXd matrix = random.symmetric(values);
      VectorXd b            = random.vector(2 * m);
      if (sample % 2 == 0) // a least energy without constraints
        b = matrix * b;
      const VectorXd radii = random.vector(m, 0.2, 2.);
      const VectorXd best  = reference_solution(matrix, b, 0, radii);
      for (Index i = 0; i < m; ++i)
        ++(std::hypot(best(i), best(i + m)) < 0.999 * radii(i) ? inside : on_circle);
      for (int method = 3; method < 7; ++method)
        {
          VectorXd x = VectorXd::Zero(2 * m), r = -b;
          not_converged += !solve(method, matrix, radii, x, r).converged;
          above.add(energy(matrix, b, x) - energy(matrix, b, best));
          distance.add((matrix * (x - best)).norm());
        }
    }
  std::cout << "Half of the spectrum zero" << std::endl;
  print("  nodes inside their disc and nodes on their circle",
        inside >= 10 && on_circle >= 10);
  print_count("  runs that did not converge", not_converged);
  print_below("  energy above the reference", above, 1e-8);
  print_below("  distance of Ax from the reference", distance, 1e-4);
}
