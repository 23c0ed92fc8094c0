// The interior point method finds solutions that were there before the problem:
// forces, gaps and slips that satisfy all conditions are chosen, and h so that
// they solve it. Q may have six eigenvalues up to 1e8 times the others, as that
// of a body that is held weakly; bounds may be given, zero, Coulomb's, or of
// each kind at some nodes; nodes may be tied. What it hands back is feasible, and the
// gradient belongs to it. It says so when it may not go on.

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/interior_point.h>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  const auto silent = [](unsigned int, double) {};
} // namespace

int main()
{
  Random random(1);
  const Index m = 24;
  const Scaling scaling{VectorXd::Ones(m), 1.};
  const VectorXd all = VectorXd::Ones(m), none = VectorXd::Zero(m);
  VectorXd some = none, others = none;
  for (Index i = 0; i < m; ++i)
    (i % 4 == 1 ? some : others)(i) = i % 5 == 2 ? 0. : 1.;
  VectorXd tied_nodes = none;
  for (Index i = 1; i < m; i += 4)
    tied_nodes(i) = tied;

  const std::vector<std::pair<std::string, SlipBound>> laws = {
    {"no friction", SlipBound::given(none)},
    {"given friction", SlipBound::given(0.3 * all)},
    {"F = 0.3", SlipBound::coulomb(0.3 * all)},
    {"F = 1", SlipBound::coulomb(all)},
    {"mixed", SlipBound::mixed(0.3 * some, 0.5 * others)},
    {"some tied", SlipBound::mixed(tied_nodes, 0.5 * others)},
    {"all tied", SlipBound::given(VectorXd::Constant(m, tied))}};
  for (const auto &[law, bound] : laws)
    for (const double ratio : {1., 1e4, 1e8})
      {
        Largest error, wrong_gradient, infeasible;
        unsigned int not_converged = 0, most_steps = 0;
        for (unsigned int problem = 0; problem < 20; ++problem)
          {
            const MatrixXd Q = weakly_held(random, 3 * m, ratio);
            VectorXd solution, r;
            choose_solution(random, bound, solution, r);
            const VectorXd h = Q * solution - r;

            VectorXd x        = problem % 2 == 0 ? VectorXd(VectorXd::Zero(3 * m))
                                                 : random.vector(3 * m, -3., 3.);
            VectorXd gradient = Q * x - h;
            const auto run =
              InteriorPoint(Q).solve(x, gradient, bound, scaling, 1e-7, 100, silent);
            not_converged += run.converged ? 0 : 1;
            most_steps = std::max(most_steps, run.interior_point_steps);
            error.add((x - solution).norm() / solution.norm());
            wrong_gradient.add((gradient - (Q * x - h)).norm() / ratio);
            VectorXd projected = x;
            project(projected, m, bound.at(x));
            infeasible.add((projected - x).norm());
          }
        std::cout << law << ", " << ratio << " times softer" << std::endl;
        print_count("Problems not solved", not_converged);
        print_below("Distance from the solution", error, 1e-5);
        print_below("Gradient handed back is wrong by", wrong_gradient, 1e-11);
        print_below("Outside of the feasible set by", infeasible, 1e-13);
        print("At most 40 steps", most_steps <= 40);
      }

  // neither one step nor all digits can do
  const MatrixXd Q = weakly_held(random, 3 * m, 1e4);
  VectorXd x = VectorXd::Zero(3 * m), r = random.vector(3 * m);
  const auto bound = SlipBound::given(0.1 * all);
  const auto one   = InteriorPoint(Q).solve(x, r, bound, scaling, 1e-12, 1, silent);
  print("After one step it does not claim success",
        !one.converged && one.interior_point_steps == 1 && one.residual > 1e-12);
  const auto exact = InteriorPoint(Q).solve(x, r, bound, scaling, 0., 1000, silent);
  print("It ends at rounding",
        !exact.converged && exact.interior_point_steps < 100 && exact.residual < 1e-9);
  VectorXd nan = VectorXd::Constant(3 * m, NAN), rn = nan;
  print("A NaN ends it",
        !InteriorPoint(Q).solve(nan, rn, bound, scaling, 1e-12, 100, silent).converged);
}
