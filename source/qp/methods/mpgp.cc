#include <stiction/qp/methods/active_set_run.h>
#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/solvers/proportioning.h>

namespace stiction
{
  Mpgp::Mpgp(const DualOperator &Q)
    : Q_(Q)
    , D_(Q.nodal_compliance().cwiseSqrt().cwiseInverse().replicate(3, 1))
    , DQD_(D_.size(),
           [&Q, D = D_](Eigen::VectorXd &dst, const Eigen::VectorXd &src) {
             Q.vmult(DualBlock::all, DualBlock::all, dst, D.cwiseProduct(src));
             dst.array() *= D.array();
           })
    , norm_(qp::spectral_norm(DQD_))
  {
  }

  DualMethodResult Mpgp::solve(DualIterate &iterate, const Task &task)
  {
    const Eigen::VectorXd bound = task.slip_bound.at(iterate.lambda);
    make_feasible(iterate, bound, Q_);

    const qp::Scaling &scaling = task.scaling;
    const Eigen::VectorXd d    = D_.head(Q_.n_nodes());
    const qp::HalfLinesTimesDiscs set(bound.cwiseQuotient(d));
    // in which the residual in y is the one in λ
    const qp::Scaling scaled{scaling.force.cwiseQuotient(d), scaling.displacement,
                             scaling.weight.size() == 0 ? d
                                                        : d.cwiseProduct(scaling.weight)};
    qp::Proportioning solver(DQD_, set, norm_, {6., true});

    Eigen::VectorXd y        = iterate.lambda.cwiseQuotient(D_);
    Eigen::VectorXd gradient = iterate.gradient.cwiseProduct(D_);
    DualMethodResult result  = run_active_set_method(
       solver, y, gradient, scaled, task.rule, products_in_an_iteration, statistics_,
       [&](const Eigen::VectorXd &now) { iterate.lambda = D_.cwiseProduct(now); },
       task.observer);
    iterate.lambda   = D_.cwiseProduct(y);
    iterate.gradient = gradient.cwiseQuotient(D_);
    return result;
  }
} // namespace stiction
