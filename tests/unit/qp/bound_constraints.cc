// On half-lines Proportioning returns the solution of the quadratic program:
// the point that brute force finds among the minimisers of all 2^n faces,
// for random matrices and for the obstacle problem of a string, from any
// start, also where a contact is about to open (x_i = r_i = 0).

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include <Eigen/Cholesky>

#include <vector>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  struct Problem
  {
    MatrixXd A;
    VectorXd b;
    double norm; // an upper bound of the largest eigenvalue
  };

  // The least energy of all feasible points that are stationary in a face.
  VectorXd best_of_all_faces(const Problem &problem)
  {
    const int n   = static_cast<int>(problem.b.size());
    VectorXd best = VectorXd::Zero(n);
    double least  = 0.;
    for (int face = 1; face < (1 << n); ++face)
      {
        std::vector<int> free;
        for (int i = 0; i < n; ++i)
          if (face & (1 << i))
            free.push_back(i);
        const int n_free = static_cast<int>(free.size());
        MatrixXd A(n_free, n_free);
        VectorXd b(n_free);
        for (int i = 0; i < n_free; ++i)
          {
            b(i) = problem.b(free[i]);
            for (int j = 0; j < n_free; ++j)
              A(i, j) = problem.A(free[i], free[j]);
          }
        const VectorXd y = A.llt().solve(b);
        if (y.minCoeff() < 0.)
          continue;
        VectorXd x = VectorXd::Zero(n);
        for (int i = 0; i < n_free; ++i)
          x(free[i]) = y(i);
        const double value = energy(problem.A, problem.b, x);
        if (value < least)
          {
            least = value;
            best  = x;
          }
      }
    return best;
  }

  // A string over an obstacle: second differences, pulled up and down.
  Problem string_problem(Random &random, const Index n)
  {
    Problem problem;
    problem.A = MatrixXd::Zero(n, n);
    problem.A.diagonal().setConstant(2.);
    problem.A.diagonal(1).setConstant(-1.);
    problem.A.diagonal(-1).setConstant(-1.);
    problem.b =
      VectorXd::Constant(n, random.uniform(-0.5, 0.)) + random.vector(n, -0.5, 0.5);
    problem.b(random.integer(static_cast<int>(n))) += 1.;
    problem.norm = 4.;
    return problem;
  }

  Problem random_problem(Random &random, const Index n)
  {
    return {random.spd(n, 1e3), random.vector(n), 1.};
  }

  // Built from its solution: about a third of the nodes carry, a third have a
  // gap, and at a third both are zero.
  Problem degenerate_problem(Random &random, const Index n)
  {
    Problem problem = random_problem(random, n);
    VectorXd x = VectorXd::Zero(n), r = VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i)
      switch (random.integer(3))
        {
          case 0:
            x(i) = random.uniform(0., 1.);
            break;
          case 1:
            r(i) = random.uniform(0., 1.);
            break;
          default:
            break;
        }
    problem.b = problem.A * x - r;
    return problem;
  }

  void check(const std::string &name, Problem (*make)(Random &, Index),
             const unsigned int n_problems)
  {
    Random random(6);
    unsigned int carrying = 0, open = 0, not_converged = 0;
    Largest distance, energy_above, products, negative;
    for (unsigned int k = 0; k < n_problems; ++k)
      {
        const Index n         = 1 + k % 10;
        const Problem problem = make(random, n);
        const VectorXd exact  = best_of_all_faces(problem);
        const HalfLines half_lines(VectorXd::Zero(n));
        for (const double entry : exact)
          ++(entry > 0. ? carrying : open);

        for (const int start : {0, 1, 2})
          for (const double gamma : {0.1, 1., 10.})
            {
              VectorXd x = VectorXd::Zero(n);
              if (start == 1)
                x = random.vector(n, 0., 2.);
              if (start == 2)
                x = random.vector(n).cwiseMax(0.);
              VectorXd gradient = problem.A * x - problem.b;
              const DenseOperator A(problem.A);
              const SolverRun statistics =
                Proportioning(A, half_lines, problem.norm, {gamma})
                  .solve(x, gradient, {VectorXd::Ones(n), 1.}, 1e-13, 10000);
              not_converged += !statistics.converged;
              negative.add(-x.minCoeff());
              distance.add((x - exact).norm());
              const double least = energy(problem.A, problem.b, exact);
              energy_above.add((energy(problem.A, problem.b, x) - least) /
                               (1. + std::abs(least)));
              products.add(statistics.multiplications);
            }
      }

    std::cout << name << std::endl;
    print("  nodes that carry and nodes that do not", carrying >= 20 && open >= 20);
    print_count("  runs that did not converge", not_converged);
    print_below("  largest infeasibility", negative, 1e-15);
    print_below("  distance from brute force", distance, 1e-9);
    print_below("  relative energy above brute force", energy_above, 1e-13);
    print("  at most 300 products a run", products.value() <= 300);
  }
} // namespace

int main()
{
  check("Random matrices of condition 1000", random_problem, 50);
  check("A string over an obstacle", string_problem, 50);
  check("Degenerate solutions", degenerate_problem, 50);
}
