#include <stiction/qp/operators/deflated_operator.h>

#include <Eigen/SVD>

#include <utility>

namespace stiction
{
  namespace
  {
    // Of the largest singular value: columns of G are no more independent than this.
    constexpr double dependent = 1e-10;
  } // namespace

  DeflatedOperator::DeflatedOperator(const DualOperator &Q,
                                     const EqualityConstraint &constraint)
    : DualOperator(Q.n_nodes())
    , Q_(Q)
  {
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(constraint.G,
                                             Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd &sigma = svd.singularValues();
    Eigen::Index rank            = 0;
    while (rank < sigma.size() && sigma(rank) > dependent * sigma(0))
      ++rank;
    const Eigen::MatrixXd V = svd.matrixV().leftCols(rank);
    constraint_.G           = svd.matrixU().leftCols(rank);
    constraint_.e =
      sigma.head(rank).cwiseInverse().cwiseProduct(V.transpose() * constraint.e);
    to_basis_ = sigma.head(rank).asDiagonal() * V.transpose();

    const Eigen::MatrixXd &G = constraint_.G;
    Q_basis_.resize(G.rows(), rank);
    Eigen::VectorXd column;
    for (Eigen::Index j = 0; j < rank; ++j)
      {
        Q.vmult(DualBlock::all, DualBlock::all, column, G.col(j));
        Q_basis_.col(j) = column;
      }
    set_right_hand_side(Q.right_hand_side() - Q_basis_ * constraint_.e);
    if (Q.matrix() == nullptr)
      return;
    // Π Q Π = Q − Ĝ Wᵀ − W Ĝᵀ + Ĝ (ĜᵀW) Ĝᵀ with W = Q Ĝ
    const Eigen::MatrixXd half = Q_basis_ - 0.5 * G * (G.transpose() * Q_basis_);
    Eigen::MatrixXd sum        = *Q.matrix();
    sum.noalias() -= G * half.transpose();
    sum.noalias() -= half * G.transpose();
    dense_ = std::make_unique<DenseDualOperator>(std::move(sum), right_hand_side());
  }

  Eigen::VectorXd DeflatedOperator::shift(const Eigen::VectorXd &lambda) const
  {
    return Q_basis_.transpose() *
           (lambda - constraint_.G * (constraint_.G.transpose() * lambda));
  }

  Eigen::VectorXd DeflatedOperator::multipliers(const Eigen::VectorXd &of_basis,
                                                const Eigen::VectorXd &lambda) const
  {
    return to_basis_.completeOrthogonalDecomposition().solve(of_basis - shift(lambda));
  }

  Eigen::VectorXd DeflatedOperator::multipliers_of_basis(
    const Eigen::VectorXd &alpha, const Eigen::VectorXd &lambda) const
  {
    return to_basis_ * alpha + shift(lambda);
  }

  const Eigen::MatrixXd *DeflatedOperator::matrix() const
  {
    return dense_ ? dense_->matrix() : nullptr;
  }

  Eigen::VectorXd DeflatedOperator::compute_nodal_compliance() const
  {
    return dense_ ? dense_->nodal_compliance()
                  : estimated_compliance(Q_.nodal_compliance());
  }

  void DeflatedOperator::apply(const DualBlock rows, const DualBlock columns,
                               Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    if (dense_)
      return dense_->vmult(rows, columns, dst, src);
    const auto G_rows    = constraint_.G.middleRows(begin(rows), length(rows));
    const auto G_columns = constraint_.G.middleRows(begin(columns), length(columns));
    const auto W_rows    = Q_basis_.middleRows(begin(rows), length(rows));
    const auto W_columns = Q_basis_.middleRows(begin(columns), length(columns));
    const Eigen::VectorXd along = G_columns.transpose() * src;
    Q_.vmult(rows, columns, dst, src);
    dst -= G_rows * (W_columns.transpose() * src) + W_rows * along -
           G_rows * (constraint_.G.transpose() * (Q_basis_ * along));
  }
} // namespace stiction
