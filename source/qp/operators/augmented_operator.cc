#include <stiction/qp/operators/augmented_operator.h>

#include <utility>

namespace stiction
{
  AugmentedOperator::AugmentedOperator(const DualOperator &Q,
                                       EqualityConstraint constraint,
                                       Eigen::VectorXd multipliers,
                                       Eigen::VectorXd weights)
    : DualOperator(Q.n_nodes())
    , Q_(Q)
    , constraint_(std::move(constraint))
    , multipliers_(std::move(multipliers))
  {
    set_weights(std::move(weights));
  }

  void AugmentedOperator::set_weights(Eigen::VectorXd weights)
  {
    weights_ = std::move(weights);
    set_multipliers(multipliers_);
    if (Q_.matrix() == nullptr)
      return;
    dense_.reset(); // of two large matrices at a time
    Eigen::MatrixXd sum = *Q_.matrix();
    sum.noalias() += constraint_.G * weights_.asDiagonal() * constraint_.G.transpose();
    dense_ = std::make_unique<DenseDualOperator>(std::move(sum), Q_.right_hand_side());
  }

  Eigen::VectorXd AugmentedOperator::multipliers(const Eigen::VectorXd &lambda) const
  {
    return multipliers_ +
           weights_.cwiseProduct(constraint_.G.transpose() * lambda - constraint_.e);
  }

  void AugmentedOperator::set_multipliers(Eigen::VectorXd multipliers)
  {
    multipliers_ = std::move(multipliers);
    set_right_hand_side(Q_.right_hand_side() -
                        constraint_.G *
                          (multipliers_ - weights_.cwiseProduct(constraint_.e)));
  }

  const Eigen::MatrixXd *AugmentedOperator::matrix() const
  {
    return dense_ ? dense_->matrix() : nullptr;
  }

  Eigen::VectorXd AugmentedOperator::compute_nodal_compliance() const
  {
    return Q_.nodal_compliance();
  }

  void AugmentedOperator::apply(const DualBlock rows, const DualBlock columns,
                                Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    if (dense_)
      return dense_->vmult(rows, columns, dst, src);
    Q_.vmult(rows, columns, dst, src);
    const auto &G = constraint_.G;
    dst += G.middleRows(begin(rows), length(rows)) *
           weights_.cwiseProduct(
             G.middleRows(begin(columns), length(columns)).transpose() * src);
  }
} // namespace stiction
