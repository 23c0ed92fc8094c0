#include <stiction/qp/contact_scales.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/verifier.h>

#include <algorithm>

namespace stiction
{
  DualProblemVerifier::DualProblemVerifier(const DualOperator &Q,
                                           const qp::SlipBound &slip_bound,
                                           const Eigen::VectorXd &areas)
    : Q_(Q)
    , slip_bound_(slip_bound)
    , share_(areas.size() > 0 ? Eigen::VectorXd(areas / areas.sum())
                              : Eigen::VectorXd::Constant(
                                  Q.n_nodes(), 1. / static_cast<double>(Q.n_nodes())))
  {
  }

  const ContactConditions &DualProblemVerifier::verify(const Eigen::VectorXd &lambda)
  {
    const Eigen::Index m = Q_.n_nodes();
    Eigen::VectorXd Q_lambda;
    Q_.vmult(DualBlock::all, DualBlock::all, Q_lambda, lambda);

    double force = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      force += Eigen::Vector3d(lambda(i), lambda(i + m), lambda(i + 2 * m)).norm();
    double work = lambda.dot(Q_lambda);
    if (force == 0.)
      {
        const DecoupledScales scales = decoupled_scales(Q_, slip_bound_);
        force                        = scales.force;
        work                         = scales.work;
      }
    qp::Scaling scaling;
    scaling.force        = share_ * (force > 0. ? force : 1.);
    scaling.displacement = force > 0. && work > 0. ? work / force : 1.;

    conditions_ = std::make_unique<ContactConditions>(
      lambda, Q_lambda - Q_.right_hand_side(), slip_bound_.at(lambda), scaling);
    if (const Eigen::MatrixXd *const Q = Q_.matrix())
      {
        double largest = 0.; // of |Q||λ|, by columns, as Q is symmetric
        for (Eigen::Index k = 0; k < Q->cols(); ++k)
          largest = std::max(largest, Q->col(k).cwiseAbs().dot(lambda.cwiseAbs()));
        conditions_->set_rounding(largest * unit_roundoff / scaling.displacement);
      }
    return *conditions_;
  }
} // namespace stiction
