#include <stiction/qp/methods/dual_iterate.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/sets/feasible_set.h>

namespace stiction
{
  double relative_change(const Eigen::VectorXd &lambda, const Eigen::VectorXd &before)
  {
    const double norm = lambda.norm();
    return norm > 0. ? (lambda - before).norm() / norm : 0.;
  }

  void make_feasible(DualIterate &iterate, const Eigen::VectorXd &slip_bound,
                     const DualOperator &Q)
  {
    const Eigen::Index m      = Q.n_nodes();
    Eigen::VectorXd projected = iterate.lambda;
    qp::HalfLinesTimesDiscs(slip_bound).project(projected);
    const Eigen::VectorXd d = projected - iterate.lambda;

    Eigen::VectorXd Qd;
    for (const DualBlock block : {DualBlock::normal, DualBlock::tangential})
      {
        const Eigen::VectorXd part =
          block == DualBlock::normal ? d.head(m) : d.tail(2 * m);
        if (part.isZero(0.))
          continue;
        Q.vmult(DualBlock::all, block, Qd, part);
        iterate.gradient += Qd;
      }
    iterate.lambda = projected;
  }
} // namespace stiction
