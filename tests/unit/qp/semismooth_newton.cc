// The semismooth Newton method ends at the solution: with given friction the
// one that a slow projected gradient method finds, on half-lines times discs
// and on discs alone, from any start; with Coulomb friction at a point that
// satisfies all conditions with its own bound. A solution that it hands back is
// feasible, and the gradient belongs to it. Direct solves of its systems do with a Q
// whose eigenvalues are up to 1e8 times each other. It says so when it may not
// go on.

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/semismooth_newton.h>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  VectorXd nodal_compliance(const MatrixXd &A, const Index m)
  {
    VectorXd c = VectorXd::Zero(m);
    for (Index k = 0; k < A.rows(); ++k)
      c(k % m) += A(k, k) * static_cast<double>(m) / static_cast<double>(A.rows());
    return c;
  }

  const auto silent = [](unsigned int, double) {};
} // namespace

int main()
{
  Random random(1);
  const Index m = 8;
  const Scaling scaling{VectorXd::Ones(m), 1.};

  for (const Index n_half_lines : {m, Index(0)})
    {
      Largest error, wrong_gradient, infeasible;
      unsigned int not_converged = 0, at_bound = 0;
      for (unsigned int problem = 0; problem < 30; ++problem)
        {
          const Index n       = n_half_lines + 2 * m;
          const MatrixXd A    = random.spd(n, 300.);
          const VectorXd b    = random.vector(n);
          VectorXd g          = random.vector(m, 0., 6.);
          g(0)                = 0.; // no friction at one node
          const VectorXd best = reference_solution(A, b, n_half_lines, g);

          const DenseOperator op(A);
          SemismoothNewton newton(op, nodal_compliance(A, m));
          VectorXd x = VectorXd::Zero(n);
          if (problem % 2 == 1)
            x = random.vector(n, -3., 3.);
          VectorXd r = A * x - b;
          const auto stat =
            newton.solve(x, r, SlipBound::given(g), scaling, 1e-12, 200, silent);
          not_converged += stat.converged ? 0 : 1;
          error.add((x - best).norm() / best.norm());
          wrong_gradient.add((r - (A * x - b)).norm());
          VectorXd projected = x;
          project(projected, n_half_lines, g);
          infeasible.add((projected - x).norm());
          for (Index i = n_half_lines; i < n_half_lines + m; ++i)
            if (std::hypot(x(i), x(i + m)) > 0.99999 * g(i - n_half_lines))
              ++at_bound;
        }
      std::cout << (n_half_lines > 0 ? "Half-lines times discs" : "Discs") << std::endl;
      print_count("Problems not solved", not_converged);
      print_below("Distance from the reference solution", error, 1e-8);
      print_below("Gradient handed back is wrong by", wrong_gradient, 1e-11);
      print_below("Outside of the feasible set by", infeasible, 1e-13);
      print("Many nodes slip, many stick", at_bound > 60 && at_bound < 200);
    }

  std::cout << "Coulomb friction" << std::endl;
  for (const double F : {0., 0.1, 0.5, 1.})
    {
      Largest residual;
      unsigned int not_converged = 0;
      double friction            = 0.;
      for (unsigned int problem = 0; problem < 30; ++problem)
        {
          const MatrixXd A = random.spd(3 * m, 30.);
          VectorXd b       = random.vector(3 * m);
          b.head(m).array() += 0.5;
          const DenseOperator op(A);
          SemismoothNewton newton(op, nodal_compliance(A, m));
          const auto bound = SlipBound::coulomb(VectorXd::Constant(m, F));
          VectorXd x = VectorXd::Zero(3 * m), r = -b;
          if (!newton.solve(x, r, bound, scaling, 1e-11, 200, silent).converged)
            ++not_converged;
          // x = P(x − r) with the bound of x itself, all of it computed here
          VectorXd y = x - (A * x - b);
          project(y, m, F * x.head(m).cwiseMax(0.));
          residual.add((x - y).norm());
          friction += x.tail(2 * m).norm();
        }
      std::cout << "F = " << F << ": not solved " << not_converged
                << ", friction acts: " << (friction > 1. ? "yes" : "no") << ", ";
      print_below("residual", residual, 1e-10);
    }

  // near the solution of a body that is held weakly: few steps, if their
  // systems are solved directly
  for (const double F : {0., 0.5})
    {
      Largest error;
      unsigned int most_steps = 0, not_converged = 0;
      const auto bound = F > 0. ? SlipBound::coulomb(VectorXd::Constant(m, F))
                                : SlipBound::given(VectorXd::Constant(m, 0.3));
      for (unsigned int problem = 0; problem < 10; ++problem)
        {
          const MatrixXd A = weakly_held(random, 3 * m, 1e8);
          VectorXd best, r;
          choose_solution(random, bound, best, r);
          const VectorXd b = A * best - r;
          const DenseOperator op(A);
          SemismoothNewton newton(op, nodal_compliance(A, m));
          newton.solve_directly(A);
          VectorXd x      = best + random.vector(3 * m, -1e-10, 1e-10);
          r               = A * x - b;
          const auto stat = newton.solve(x, r, bound, scaling, 1e-6, 100, silent);
          most_steps      = std::max(most_steps, stat.newton_steps);
          not_converged += stat.converged ? 0 : 1;
          error.add((x - best).norm() / best.norm());
        }
      std::cout << (F > 0. ? "Coulomb" : "Given") << " friction, held weakly"
                << std::endl;
      print_count("Problems not solved", not_converged);
      print_below("Distance from the solution", error, 1e-6);
      print("At most 10 steps", most_steps <= 10);
    }

  // one step is not enough, and that is said
  {
    const MatrixXd A = random.spd(3 * m, 300.);
    const VectorXd b = random.vector(3 * m);
    const DenseOperator op(A);
    SemismoothNewton newton(op, nodal_compliance(A, m));
    VectorXd x = VectorXd::Zero(3 * m), r = -b;
    const auto bound = SlipBound::given(VectorXd::Constant(m, 0.1));
    const auto stat  = newton.solve(x, r, bound, scaling, 1e-12, 1, silent);
    print("After one step it does not claim success",
          !stat.converged && stat.newton_steps == 1 && stat.residual > 1e-12);
    VectorXd nan = VectorXd::Constant(3 * m, NAN), rn = nan;
    print("A NaN ends it",
          !newton.solve(nan, rn, bound, scaling, 1e-12, 100, silent).converged);
  }
}
