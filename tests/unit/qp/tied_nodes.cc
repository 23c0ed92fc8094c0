// Nodes that are tied, beside others: every dual method finds the forces that were chosen
// before the problem. The sets that have such nodes project and step as their nodes of
// other kinds do when they stand alone.

#include <stiction/qp/methods/admm.h>
#include <stiction/qp/methods/coulomb_fixed_point.h>
#include <stiction/qp/methods/gauss_seidel.h>
#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/methods/newton.h>
#include <stiction/qp/methods/squares.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/unbalanced_load.h>

#include <functional>
#include <memory>

#include "qp_tests.h"

using namespace stiction;
using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  const Index m = 24;

  VectorXd every_third_tied(const double otherwise)
  {
    VectorXd c = VectorXd::Constant(m, otherwise);
    for (Index i = 1; i < m; i += 3)
      c(i) = tied;
    return c;
  }

  using Make = std::function<std::unique_ptr<DualMethod>(const DualOperator &)>;

  void check(const std::string &name, const SlipBound &bound, const Make &make)
  {
    Random random(4);
    Largest error, wrong_gradient;
    unsigned int not_converged = 0;
    for (unsigned int problem = 0; problem < 10; ++problem)
      {
        const MatrixXd Q = weakly_held(random, 3 * m, 1.);
        VectorXd solution, r;
        choose_solution(random, bound, solution, r);
        const DenseDualOperator op(Q, Q * solution - r);
        DualIterate iterate{VectorXd::Zero(3 * m), -op.right_hand_side()};
        const auto result =
          make(op)->solve(iterate, {bound, {VectorXd::Ones(m), 1.}, {1e-9, 1., 10000}});
        not_converged += result.converged ? 0 : 1;
        error.add((iterate.lambda - solution).norm() / solution.norm());
        wrong_gradient.add(
          (iterate.gradient - (Q * iterate.lambda - op.right_hand_side())).norm());
      }
    std::cout << name << std::endl;
    print_count("  problems not solved", not_converged);
    print_below("  distance from the solution", error, 1e-6);
    print_below("  gradient handed back is wrong by", wrong_gradient, 1e-8);
  }

  // Nodes 1, 4, ... of the whole space, the others of the set without these.
  void check_set(const std::string &name, const FeasibleSet &set,
                 const FeasibleSet &plain)
  {
    Random random(5);
    bool projects = true, steps = true;
    for (unsigned int sample = 0; sample < 100; ++sample)
      {
        const VectorXd z = random.vector(set.size(), -3., 3.);
        VectorXd Pz = z, plain_Pz = z;
        set.project(Pz);
        plain.project(plain_Pz);
        VectorXd d       = random.vector(set.size(), -1., 1.);
        VectorXd plain_d = d;
        for (Index k = 0; k < set.size(); ++k)
          {
            const bool is_tied = k % m % 3 == 1;
            projects           = projects && Pz(k) == (is_tied ? z(k) : plain_Pz(k));
            plain_d(k)         = is_tied ? 0. : d(k);
          }
        steps = steps && set.largest_feasible_step(Pz, d) ==
                           plain.largest_feasible_step(plain_Pz, plain_d);
        VectorXd free, chopped;
        set.split(Pz, d, 0.1, free, chopped);
        for (Index k = 0; k < set.size(); ++k)
          if (k % m % 3 == 1)
            projects = projects && free(k) == d(k) && chopped(k) == 0.;
      }
    print(name + ": projects", projects);
    print(name + ": steps", steps);
  }

  // One rigid body that may move along three axes, tied at one node or not.
  void balance_a_pull()
  {
    EqualityConstraint balance{MatrixXd::Zero(6, 3), VectorXd(3)};
    for (Index i = 0; i < 2; ++i)
      for (Index c = 0; c < 3; ++c)
        balance.G(i + 2 * c, c) = 1.;
    for (const double pull : {-1., 1.})
      {
        balance.e << pull, 0.3, -0.4;
        VectorXd c(2);
        c << tied, 0.;
        const auto with_tie = unbalanced_load(balance, SlipBound::given(c));
        print("A tie bears " + std::string(pull < 0. ? "a pull" : "pressure"),
              with_tie.is_balanced() &&
                (balance.G.transpose() * with_tie.lambda - balance.e).norm() < 1e-7);
        print(
          "Contact without friction does not",
          !unbalanced_load(balance, SlipBound::given(VectorXd::Zero(2))).is_balanced());
      }
  }
} // namespace

int main()
{
  const VectorXd zero = VectorXd::Zero(m), radii = VectorXd::Constant(m, 0.7),
                 tied_radii = every_third_tied(0.7);
  check_set("half-lines", HalfLines(tied_radii), HalfLines(radii));
  check_set("discs", Discs(tied_radii), Discs(radii));
  check_set("both", HalfLinesTimesDiscs(tied_radii), HalfLinesTimesDiscs(radii));
  check_set("boxes", HalfLinesTimesBoxes(tied_radii, 2), HalfLinesTimesBoxes(radii, 2));
  balance_a_pull();

  const auto given   = SlipBound::given(every_third_tied(0.3));
  const auto coulomb = SlipBound::mixed(every_third_tied(0.), VectorXd::Constant(m, 0.3));
  const auto newton  = [](const DualOperator &Q) { return std::make_unique<Newton>(Q); };
  const auto gauss_seidel = [](const DualOperator &Q) {
    return std::make_unique<GaussSeidel>(Q);
  };
  for (const bool is_coulomb : {false, true})
    {
      const SlipBound &bound = is_coulomb ? coulomb : given;
      std::cout << "-- " << (is_coulomb ? "F = 0.3" : "given friction") << std::endl;
      check("newton", bound, newton);
      check("newton inside", bound,
            [](const DualOperator &Q) { return std::make_unique<Newton>(Q, 1); });
      check("gauss seidel", bound, gauss_seidel);
      check("gauss seidel, discs", bound, [](const DualOperator &Q) {
        return std::make_unique<GaussSeidel>(Q, DiscActiveSet::Variant::spectral);
      });
      check("admm", bound,
            [](const DualOperator &Q) { return std::make_unique<Admm>(Q); });
      if (is_coulomb)
        check("fixed point", bound, [&](const DualOperator &Q) {
          return std::make_unique<CoulombFixedPoint>(newton(Q));
        });
      else
        check("mpgp", bound,
              [](const DualOperator &Q) { return std::make_unique<Mpgp>(Q); });
    }
  check("squares, without friction", SlipBound::given(every_third_tied(0.)),
        [](const DualOperator &Q) { return std::make_unique<Squares>(Q, 1); });
}
