#include <stiction/qp/operators/symmetric_operator.h>

namespace stiction::qp
{
  void SymmetricOperator::vmult(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    eigen_assert(src.size() == size());
    ++n_multiplications_;
    apply(dst, src);
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
