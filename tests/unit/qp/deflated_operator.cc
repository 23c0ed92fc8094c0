// The dual operator of a body without its rigid motions: the gradient of the problem with
// the multipliers that it names, in all blocks, by matrix and by action alone; whatever
// holds the body for the inverse of its stiffness; with motions that depend on each
// other.

#include <stiction/qp/operators/deflated_operator.h>

#include "by_action.h"
#include "qp_tests.h"

using namespace stiction;
using namespace qp_tests;

namespace
{
  MatrixXd matrix(Random &random, const Index rows, const Index columns)
  {
    MatrixXd A(rows, columns);
    for (Index j = 0; j < columns; ++j)
      A.col(j) = random.vector(rows);
    return A;
  }

  VectorXd product(const DualOperator &Q, const VectorXd &v,
                   const DualBlock rows    = DualBlock::all,
                   const DualBlock columns = DualBlock::all)
  {
    VectorXd result;
    Q.vmult(rows, columns, result, v);
    return result;
  }
} // namespace

int main()
{
  Random random(3);
  const Index m = 12, n = 6;
  const MatrixXd A = matrix(random, 3 * m, 3 * m), G = matrix(random, 3 * m, n);
  const MatrixXd Q = A * A.transpose();
  const VectorXd h = random.vector(3 * m), e = random.vector(n), alpha = random.vector(n);

  const DenseDualOperator dense(Q, h);
  const ByAction by_action(Q, h);
  // another inverse of the stiffness of a free body differs by rigid motions
  const MatrixXd X       = matrix(random, 3 * m, n);
  const MatrixXd other_Q = Q + G * X.transpose() + X * G.transpose();
  const DenseDualOperator other(other_Q, h + X * e);
  // motions that depend on each other
  MatrixXd G7(3 * m, n + 1);
  G7 << G, G.col(0) - 2. * G.col(3);
  VectorXd e7(n + 1);
  e7 << e, e(0) - 2. * e(3);

  const DeflatedOperator deflated(dense, {G, e});
  const DeflatedOperator without_matrix(by_action, {G, e});
  const DeflatedOperator same(other, {G, e});
  const DeflatedOperator dependent(dense, {G7, e7});
  const MatrixXd basis = deflated.constraint().G;

  // forces that satisfy the constraint
  VectorXd lambda = random.vector(3 * m);
  lambda += deflated.lacking(lambda);
  const VectorXd gradient = Q * lambda - h + G * alpha;
  const auto is_gradient  = [&](const DeflatedOperator &operator_) {
    const VectorXd multipliers = operator_.multipliers_of_basis(alpha, lambda);
    return (product(operator_, lambda) - operator_.right_hand_side() +
            operator_.constraint().G * multipliers - gradient)
             .norm() < 1e-11 * gradient.norm();
  };
  std::cout << "forces that lacked nothing: "
            << yes((G.transpose() * lambda - e).norm() < 1e-12 * e.norm()) << std::endl;
  std::cout << "basis orthonormal: "
            << yes((basis.transpose() * basis - MatrixXd::Identity(n, n)).norm() < 1e-13)
            << ", of rank 6 where 7 motions depend: "
            << yes(dependent.constraint().G.cols() == n) << std::endl;
  std::cout << "the gradient: with a matrix " << yes(is_gradient(deflated))
            << ", without " << yes(is_gradient(without_matrix)) << std::endl;
  std::cout << "multipliers there and back: "
            << yes((deflated.multipliers(deflated.multipliers_of_basis(alpha, lambda),
                                         lambda) -
                    alpha)
                     .norm() < 1e-11 * alpha.norm())
            << std::endl;
  const VectorXd v = random.vector(3 * m);
  std::cout << "no rigid motion is felt: "
            << yes(product(deflated, G * alpha).norm() < 1e-11 * (Q * G * alpha).norm())
            << ", the inverse does not matter: "
            << yes((product(same, v) - product(deflated, v)).norm() <
                   1e-10 * product(deflated, v).norm())
            << std::endl;
  double error = 0.;
  for (const DualBlock rows : {DualBlock::normal, DualBlock::tangential, DualBlock::all})
    for (const DualBlock columns :
         {DualBlock::normal, DualBlock::tangential, DualBlock::all})
      {
        const Index size    = columns == DualBlock::normal       ? m
                              : columns == DualBlock::tangential ? 2 * m
                                                                 : 3 * m;
        const VectorXd part = random.vector(size);
        error = std::max(error, (product(without_matrix, part, rows, columns) -
                                 product(deflated, part, rows, columns))
                                  .norm());
      }
  std::cout << "by blocks as by its matrix: " << yes(error < 1e-10 * Q.norm())
            << std::endl;
  std::cout << "nodal compliance positive: "
            << yes((deflated.nodal_compliance().array() > 0.).all() &&
                   (without_matrix.nodal_compliance().array() > 0.).all())
            << std::endl;
}
