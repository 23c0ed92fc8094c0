#include <stiction/qp/sets/contact_linearization.h>
#include <stiction/qp/solvers/nystrom_preconditioner.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace stiction::qp
{
  namespace
  {
    // More directions than this gain nothing on the reference brick.
    constexpr Eigen::Index max_directions = 40;

    // Directions that others nearly span add rounding only.
    constexpr double rank_tolerance = 1e-8;

    // The diagonal keeps at least this part of the compliance: what Q̂ lacks
    // of Q is not diagonal. 0.1 costs a quarter more products, 0.3 to 0.8 are
    // alike.
    constexpr double least_diagonal = 0.5;
  } // namespace

  void NystromPreconditioner::add(const Eigen::VectorXd &d, const Eigen::VectorXd &Qd)
  {
    const double scale   = 1. / std::sqrt(d.dot(Qd));
    const Eigen::Index k = directions_.cols();
    if (k >= max_directions || !std::isfinite(scale))
      return;
    directions_.conservativeResize(d.size(), k + 1);
    images_.conservativeResize(d.size(), k + 1);
    directions_.col(k) = scale * d;
    images_.col(k)     = scale * Qd;
    is_current_        = false;
  }

  void NystromPreconditioner::update_root()
  {
    Eigen::MatrixXd gram = directions_.transpose() * images_;
    gram                 = (0.5 * (gram + gram.transpose())).eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(gram);
    const Eigen::VectorXd &values = spectrum.eigenvalues(); // ascending
    const Eigen::Index rank =
      (values.array() > rank_tolerance * values(values.size() - 1)).count();
    root_       = images_ * (spectrum.eigenvectors().rightCols(rank) *
                       values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal());
    is_current_ = true;
  }

  void NystromPreconditioner::set_up(const ContactLinearization &step,
                                     const Eigen::VectorXd &nodal_compliance)
  {
    if (!is_current_)
      update_root();

    trial_root_.resize(step.n_free(), root_.cols());
    test_root_.resize(step.n_free(), root_.cols());
    for (Eigen::Index j = 0; j < root_.cols(); ++j)
      {
        trial_root_.col(j) = step.transpose_embed(root_.col(j));
        test_root_.col(j)  = step.test(root_.col(j));
      }

    diagonal_ = step.curvature();
    for (Eigen::Index k = 0; k < step.n_free(); ++k)
      {
        const double compliance = nodal_compliance(step.node(k));
        diagonal_(k) += std::max(compliance - trial_root_.row(k).squaredNorm(),
                                 least_diagonal * compliance);
      }

    capacitance_.compute(Eigen::MatrixXd::Identity(root_.cols(), root_.cols()) +
                         trial_root_.transpose() * diagonal_.cwiseInverse().asDiagonal() *
                           test_root_);
  }

  Eigen::VectorXd NystromPreconditioner::apply(const Eigen::VectorXd &v) const
  {
    Eigen::VectorXd z = v.cwiseQuotient(diagonal_);
    if (root_.cols() > 0)
      z -= (test_root_ * capacitance_.solve(trial_root_.transpose() * z))
             .cwiseQuotient(diagonal_);
    return z;
  }
} // namespace stiction::qp
