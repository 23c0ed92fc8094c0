#include <stiction/qp/operators/squares_operator.h>
#include <stiction/qp/sets/rotated_squares.h>

namespace stiction::qp
{
  SquaresOperator::SquaresOperator(const SymmetricOperator &Q,
                                   const RotatedSquares &squares)
    : Q_(Q)
    , squares_(squares)
  {
    eigen_assert(Q.size() == 3 * squares.n_nodes());
  }

  Eigen::Index SquaresOperator::size() const
  {
    return squares_.n_unknowns();
  }

  void SquaresOperator::apply(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    Eigen::VectorXd Q_forces;
    Q_.vmult(Q_forces, squares_.to_forces(src));
    dst = squares_.pull_back(Q_forces);
  }
} // namespace stiction::qp
