#include <stiction/contact/pairs/wavering.h>

#include <limits>

namespace stiction
{
  double wavering(const Eigen::SparseMatrix<double, Eigen::RowMajor> &weights,
                  const Eigen::MatrixX3d &forces, const Eigen::VectorXd &areas)
  {
    // of degree 2 some weights are negative
    const auto W    = weights.cwiseAbs().eval();
    const auto mean = [](const Eigen::MatrixX3d &sums, const Eigen::VectorXd &of) {
      return Eigen::MatrixX3d(
        of.cwiseMax(std::numeric_limits<double>::min()).cwiseInverse().asDiagonal() *
        sums);
    };
    const Eigen::MatrixX3d felt   = mean(W.transpose() * forces, W.transpose() * areas);
    const Eigen::MatrixX3d smooth = mean(W * felt, W * Eigen::VectorXd::Ones(W.cols()));
    return (forces - areas.asDiagonal() * smooth).rowwise().norm().sum() /
           forces.rowwise().norm().sum();
  }
} // namespace stiction
