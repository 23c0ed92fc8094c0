// The norm of A that a method is given is an estimate. Where it is three times
// too small the fixed step would overshoot: every method notices, its energy
// falls in each step all the same, and it reaches the solution. A norm that is
// right is left alone, also on the stiffest mode.

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/disc_active_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include <Eigen/Eigenvalues>

#include <memory>

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

  struct Run
  {
    Run(const int method, const MatrixXd &matrix, const VectorXd &radii,
        const double norm)
      : A(matrix)
      , discs(radii)
      , half_lines(VectorXd::Zero(radii.size()))
      , product(radii)
    {
      if (method < 6)
        solver = std::make_unique<DiscActiveSet>(
          A, discs, norm, static_cast<DiscActiveSet::Variant>(method));
      else if (method == 6)
        solver = std::make_unique<Proportioning>(A, half_lines, norm);
      else if (method == 7)
        solver = std::make_unique<Proportioning>(A, discs, norm);
      else
        solver = std::make_unique<Proportioning>(A, product, norm);
    }

    DenseOperator A;
    Discs discs;
    HalfLines half_lines;
    HalfLinesTimesDiscs product;
    std::unique_ptr<ActiveSetMethod> solver;
  };

  void check(const int method)
  {
    Random random(21);
    unsigned int not_converged = 0, not_stopped = 0;
    Largest distance, rise;
    for (unsigned int sample = 0; sample < 30; ++sample)
      {
        const Index m      = 1 + sample % 5;
        const Index n      = method < 6 || method == 7 ? 2 * m : method == 6 ? m : 3 * m;
        const Index normal = n == 2 * m ? 0 : m;
        const MatrixXd matrix = random.spd(n, 10.);
        const VectorXd b      = random.vector(n, -2., 3.);
        const VectorXd radii  = random.vector(m, 0.2, 2.);
        const VectorXd discs  = n == m ? VectorXd(0) : radii;
        const Scaling scaling{VectorXd::Ones(m), 1.};
        const double norm =
          Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix).eigenvalues().maxCoeff();
        const VectorXd reference = reference_solution(matrix, b, normal, discs);

        VectorXd start = random.vector(n, -2., 2.);
        project(start, normal, discs);
        double before = energy(matrix, b, start);
        for (unsigned int max = 1; max <= 40; ++max)
          {
            VectorXd x = start, r = matrix * x - b;
            Run(method, matrix, radii, norm / 3.).solver->solve(x, r, scaling, 1e-6, max);
            const double now = energy(matrix, b, x);
            rise.add(now - before);
            before = now;
          }

        // the second run of the object knows the right step already
        Run run(method, matrix, radii, norm / 3.);
        for (int repeat = 0; repeat < 2; ++repeat)
          {
            VectorXd x = start, r = matrix * x - b;
            const SolverRun statistics = run.solver->solve(x, r, scaling, 1e-10, 5000);
            not_converged += !statistics.converged;
            not_stopped += !(statistics.multiplications < 2500);
            distance.add((x - reference).norm());
          }
      }
    std::cout << names[method] << std::endl;
    print_below("  largest rise of the energy", rise, 1e-13);
    print_count("  runs that did not converge", not_converged);
    print_count("  runs with 2500 products or more", not_stopped);
    print_below("  distance from the reference", distance, 1e-8);
  }

  // One node and A = diag(1, 1): a release is one fixed step along r, so the
  // products tell how often it was done again.
  unsigned int products_of_one_release(const double norm)
  {
    const MatrixXd matrix = MatrixXd::Identity(2, 2);
    const DenseOperator A(matrix);
    const Discs disc(VectorXd::Ones(1));
    VectorXd x(2), r(2);
    x << 1., 0.;
    r << 0.02, 0.05; // on the circle and out of balance
    return DiscActiveSet(A, disc, norm, DiscActiveSet::Variant::with_projected_release)
      .solve(x, r, {VectorXd::Ones(1), 1.}, 1e-14, 1)
      .multiplications;
  }
} // namespace

int main()
{
  for (int method = 0; method < 9; ++method)
    check(method);

  std::cout << "Products of one release" << std::endl;
  print_count("  norm right", products_of_one_release(1.));
  print_count("  norm 2 % too small", products_of_one_release(0.98));
  print_count("  norm 3 times too small", products_of_one_release(1. / 3.));
}
