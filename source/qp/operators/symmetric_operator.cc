#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/slip_bound.h>

namespace stiction::qp
{
  void SymmetricOperator::vmult(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    eigen_assert(src.size() == size());
    ++n_multiplications_;
    apply(dst, src);
  }

  void make_feasible(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                     const SymmetricOperator &A, const SlipBound &slip_bound)
  {
    Eigen::VectorXd projected = x;
    project(projected, slip_bound);
    const Eigen::VectorXd d = projected - x;
    if (d.isZero(0.))
      return;
    Eigen::VectorXd Ad;
    A.vmult(Ad, d);
    x = projected;
    gradient += Ad;
  }

  DenseOperator::DenseOperator(const Eigen::MatrixXd &matrix)
    : matrix_(matrix)
  {
    eigen_assert(matrix.rows() == matrix.cols());
  }

  Eigen::Index DenseOperator::size() const
  {
    return matrix_.rows();
  }

  void DenseOperator::apply(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    dst.noalias() = matrix_ * src;
  }
} // namespace stiction::qp
