#include <stiction/qp/contact_conditions.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/nodal_blocks.h>

namespace stiction
{
  std::vector<NodeStatus> node_statuses(const ContactConditions &conditions,
                                        const qp::SlipBound &slip_bound,
                                        const Eigen::VectorXd &stiffness,
                                        const double tolerance)
  {
    const qp::Scaling &scaling = conditions.scaling();
    const double figure        = conditions.worst_figure().second;
    const double rounding      = tolerance / 100.;
    const double accuracy      = figure <= rounding ? rounding : figure; // or NaN
    const double error         = 5. * accuracy; // of gap and slip

    std::vector<NodeStatus> statuses;
    statuses.reserve(slip_bound.n_nodes());
    for (Eigen::Index i = 0; i < slip_bound.n_nodes(); ++i)
      {
        const double force      = scaling.force(i);
        const double u0         = scaling.displacement_at(i);
        const Eigen::Vector3d a = at_node(conditions.lambda(), i) / force -
                                  at_node(conditions.gradient(), i) / u0;
        const double F           = slip_bound.coefficient()(i);
        const double force_error = error * (1. + stiffness(i) * u0 / force);

        if (slip_bound.is_tied(i))
          {
            statuses.push_back({NormalStatus::closed, TangentialStatus::tied});
            continue;
          }
        // a NaN is neither above nor below
        NodeStatus status{NormalStatus::undecided, TangentialStatus::undecided};
        if (a(0) > force_error)
          status.normal = NormalStatus::closed;
        else if (a(0) < -error)
          status.normal = NormalStatus::open;

        const bool needs_pressure = slip_bound.constant()(i) == 0.;
        const double excess = a.tail<2>().norm() - conditions.slip_bound()(i) / force;
        if (needs_pressure && (F == 0. || status.normal == NormalStatus::open))
          status.tangential = TangentialStatus::none;
        else if (needs_pressure && status.normal == NormalStatus::undecided)
          status.tangential = TangentialStatus::undecided;
        else if (excess > error)
          status.tangential = TangentialStatus::slip;
        else if (excess < -(1. + F) * force_error)
          status.tangential = TangentialStatus::stick;
        statuses.push_back(status);
      }
    return statuses;
  }
} // namespace stiction
