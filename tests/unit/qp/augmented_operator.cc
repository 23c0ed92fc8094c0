// An equality constraint on the contact forces: the augmented operator has the
// gradient of the problem with the multipliers that it names, in all its blocks,
// and these multipliers lead to those of problems made for their solution.

#include <stiction/qp/certified_solve.h>
#include <stiction/qp/methods/newton.h>
#include <stiction/qp/operators/augmented_operator.h>
#include <stiction/qp/verifier.h>

#include "by_action.h"
#include "qp_tests.h"

using namespace stiction;
using namespace qp_tests;

namespace
{
  // Where nodes are open, stick and slip, in turn.
  struct Solution
  {
    VectorXd lambda, r, bound;
  };

  Solution make_solution(Random &random, const Index m)
  {
    Solution made{VectorXd::Zero(3 * m), VectorXd::Zero(3 * m), VectorXd::Ones(m)};
    for (Index i = 0; i < m; ++i)
      {
        const Eigen::Vector2d t = Eigen::Vector2d(random.vector(2)).normalized();
        if (i % 3 == 0)
          made.r(i) = random.uniform(0.5, 1.);
        else
          made.lambda(i) = random.uniform(0.5, 1.);
        const double size      = i % 3 == 1 ? 0.5 : 1.;
        made.lambda(i + m)     = size * t(0);
        made.lambda(i + 2 * m) = size * t(1);
        if (i % 3 != 1)
          {
            made.r(i + m)     = -0.3 * t(0);
            made.r(i + 2 * m) = -0.3 * t(1);
          }
      }
    return made;
  }
} // namespace

int main()
{
  Random random(7);
  const Index m = 12;
  Largest wrong_gradient, wrong_blocks, error, error_of_multipliers;
  unsigned int not_solved = 0, slow = 0;
  for (unsigned int problem = 0; problem < 10; ++problem)
    {
      const MatrixXd Q      = random.spd(3 * m, 100.);
      const Solution made   = make_solution(random, m);
      const VectorXd alpha  = random.vector(2);
      const auto constraint = [&]() {
        EqualityConstraint made_for{MatrixXd(3 * m, 2), {}};
        made_for.G.col(0) = random.vector(3 * m);
        made_for.G.col(1) = random.vector(3 * m);
        made_for.e        = made_for.G.transpose() * made.lambda;
        return made_for;
      }();
      const VectorXd h = Q * made.lambda - made.r + constraint.G * alpha;
      const DenseDualOperator dense(Q, h);
      const ByAction action(Q, h);
      const VectorXd weights = random.vector(2, 20., 40.), zero = VectorXd::Zero(2);
      AugmentedOperator augmented(dense, constraint, random.vector(2), weights);
      const AugmentedOperator by_action(action, constraint, zero, weights);

      const VectorXd x = random.vector(3 * m);
      VectorXd image;
      augmented.vmult(DualBlock::all, DualBlock::all, image, x);
      wrong_gradient.add((image - augmented.right_hand_side() -
                          (Q * x - h + constraint.G * augmented.multipliers(x)))
                           .norm());
      for (const auto rows : {DualBlock::normal, DualBlock::tangential})
        for (const auto columns : {DualBlock::normal, DualBlock::tangential})
          {
            const VectorXd part =
              columns == DualBlock::normal ? x.head(m) : x.tail(2 * m);
            VectorXd here, there;
            augmented.vmult(rows, columns, here, part);
            by_action.vmult(rows, columns, there, part);
            wrong_blocks.add((here - there).norm());
          }

      augmented.set_multipliers(zero);
      const auto bound = qp::SlipBound::given(made.bound);
      VectorXd lambda;
      double last = 1e300;
      for (unsigned int k = 0; k < 60 && last > 1e-10; ++k)
        {
          Newton method(augmented);
          DualProblemVerifier verifier(augmented, bound, {});
          const auto status = certified_solve(
            method, augmented, bound, verifier, 1e-12, 1000, "",
            [](const ContactStep &) {}, lambda);
          not_solved += status.converged ? 0 : 1;
          augmented.set_multipliers(augmented.multipliers(lambda));
          const double violation =
            (constraint.G.transpose() * lambda - constraint.e).norm();
          slow += violation > 0.9 * last ? 1 : 0;
          last = violation;
        }
      error.add((lambda - made.lambda).norm());
      error_of_multipliers.add((augmented.multipliers(made.lambda) - alpha).norm());
    }
  print_below("gradient of the problem with its multipliers", wrong_gradient, 1e-10);
  print_below("blocks with and without a matrix", wrong_blocks, 1e-10);
  print_count("problems not solved", not_solved);
  print_count("steps in which the constraint came no closer", slow);
  print_below("distance from the solution", error, 1e-8);
  print_below("of the multipliers", error_of_multipliers, 1e-8);
}
