#include <stiction/qp/methods/active_set_run.h>
#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/solvers/proportioning.h>

namespace stiction
{
  Mpgp::Mpgp(const DualOperator &Q)
    : Q_(Q)
    , block_(Q, DualBlock::all)
    , nodal_scaling_(Q.nodal_compliance().cwiseSqrt().cwiseInverse())
    , scaled_block_(block_, nodal_scaling_)
    , norm_(qp::spectral_norm(scaled_block_))
  {
  }

  DualMethodResult Mpgp::solve(DualIterate &iterate, const qp::SlipBound &slip_bound,
                               const qp::Scaling &scaling, const StoppingRule &rule,
                               const Observer &observer)
  {
    const Eigen::VectorXd bound = slip_bound.at(iterate.lambda);
    make_feasible(iterate, bound, Q_);

    const qp::HalfLinesTimesDiscs set(nodal_scaling_.divide(bound));
    qp::ProportioningOptions options;
    options.gamma            = 6.;
    options.spectral_release = true;
    qp::Proportioning solver(scaled_block_, set, norm_, options);

    Eigen::VectorXd x             = nodal_scaling_.divide(iterate.lambda);
    Eigen::VectorXd gradient      = nodal_scaling_.times(iterate.gradient);
    const DualMethodResult result = run_active_set_method(
      solver, x, gradient, nodal_scaling_.scaled(scaling), rule, products_in_an_iteration,
      statistics_,
      [&](const Eigen::VectorXd &now) { iterate.lambda = nodal_scaling_.times(now); },
      observer);
    iterate.lambda   = nodal_scaling_.times(x);
    iterate.gradient = nodal_scaling_.divide(gradient);
    return result;
  }
} // namespace stiction
