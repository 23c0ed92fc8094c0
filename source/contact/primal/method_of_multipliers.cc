#include <stiction/contact/primal/contact_level.h>
#include <stiction/contact/primal/method_of_multipliers.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/sets/feasible_set.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    // ρ over the stiffness of a node. Any works; the larger, the fewer updates
    // of the multipliers and the stiffer the springs.
    constexpr double relative_rho = 10.;

    // A minimisation ends at this part of what the conditions lack.
    constexpr double inner_accuracy  = 0.1;
    constexpr double linear_accuracy = 0.1;

    constexpr unsigned int max_updates = 300;
  } // namespace

  MethodOfMultipliers::MethodOfMultipliers(const ContactLevel &problem,
                                           NewtonSystem &system)
    : problem_(problem)
    , system_(system)
    , rho_(relative_rho * problem.nodal_stiffness())
  {
  }

  Eigen::VectorXd MethodOfMultipliers::forces(const Eigen::VectorXd &w) const
  {
    Eigen::VectorXd a = multipliers_ + rho_.replicate(3, 1).cwiseProduct(w);
    qp::HalfLinesTimesDiscs(slip_bound_).project(a);
    return a;
  }

  PrimalActiveSet MethodOfMultipliers::linearize(const Eigen::VectorXd &w) const
  {
    const Eigen::Index m        = rho_.size();
    const Eigen::VectorXd a     = multipliers_ + rho_.replicate(3, 1).cwiseProduct(w);
    const Eigen::VectorXd force = forces(w);

    PrimalActiveSet result(m);
    for (Eigen::Index i = 0; i < m; ++i)
      {
        PrimalActiveSet::Node &node = result.nodes[i];
        if (a(i) > 0. || qp::is_tied(slip_bound_(i)))
          node.spring(0, 0) = rho_(i);
        const Eigen::Vector2d a_t(a(i + m), a(i + 2 * m));
        const double norm = a_t.norm();
        if (norm <= slip_bound_(i))
          node.spring.bottomRightCorner<2, 2>() = rho_(i) * Eigen::Matrix2d::Identity();
        else if (slip_bound_(i) > 0.)
          {
            const Eigen::Vector2d across(-a_t(1) / norm, a_t(0) / norm);
            node.spring.bottomRightCorner<2, 2>() =
              rho_(i) * slip_bound_(i) / norm * across * across.transpose();
          }
        // where nothing holds the body a step stays near (a proximal point method)
        node.spring += problem_.foundation()(i) * Eigen::Matrix3d::Identity();
        node.load = at_node(force, i) - node.spring * at_node(w, i);
      }
    return result;
  }

  bool MethodOfMultipliers::search(ContactState &state, const ContactState &before) const
  {
    // along u + α d the derivative of the energy is
    // −R(α)ᵀd + Σ ∇ψ(w + α Bd)·Bd − P·δ, with R linear in α
    LA::Vector d = state.u;
    d -= before.u;
    const double at_start     = before.R * d;
    const double at_end       = state.R * d;
    const Eigen::VectorXd d_w = state.w - before.w;
    const double pressing =
      problem_.motion().forces().dot(state.distances - before.distances);
    const auto slope = [&](const double alpha) {
      return -((1. - alpha) * at_start + alpha * at_end) +
             forces(before.w + alpha * d_w).dot(d_w) - pressing;
    };

    const double first = slope(0.);
    if (!(first < 0.))
      return false;
    if (slope(1.) <= -linear_accuracy * first)
      return true;
    double low = 0., high = 1., alpha = 0.5;
    for (unsigned int k = 0; k < 60; ++k)
      {
        alpha              = 0.5 * (low + high);
        const double value = slope(alpha);
        if (std::abs(value) <= -linear_accuracy * first)
          break;
        (value < 0. ? low : high) = alpha;
      }
    state.u.sadd(alpha, 1. - alpha, before.u);
    state.R.sadd(alpha, 1. - alpha, before.R);
    state.w         = before.w + alpha * d_w;
    state.distances = (1. - alpha) * before.distances + alpha * state.distances;
    state.lambda    = (1. - alpha) * before.lambda + alpha * state.lambda;
    return true;
  }

  qp::IterationCounts MethodOfMultipliers::solve(ContactState &state,
                                                 const Eigen::VectorXd &slip_bound,
                                                 const double tolerance,
                                                 const unsigned int max_newton_steps)
  {
    qp::IterationCounts effort;
    unsigned int updates = 0; // of the multipliers
    slip_bound_          = slip_bound;
    multipliers_         = state.lambda;
    qp::HalfLinesTimesDiscs(slip_bound_).project(multipliers_);

    while (effort.newton_steps < max_newton_steps)
      {
        problem_.bring_into_contact(state, forces(state.w));
        const ContactResidual residual(problem_, state,
                                       qp::SlipBound::given(slip_bound_));
        if (residual.value() <= tolerance)
          break;
        const qp::Scaling &scaling = residual.conditions.scaling();

        // what the forces lack to be those of the multipliers and springs,
        // and what these lack to satisfy the conditions
        const Eigen::VectorXd force = forces(state.w);
        const double imbalance      = std::max(
               {residual.equilibrium, largest_at_nodes(state.lambda - force, scaling.force),
                problem_.motion().force_error(force)});
        const double violation = ContactConditions(force, -state.w, slip_bound_, scaling)
                                   .contact_figures()
                                   .kkt_residual;
        if (imbalance <= std::max(inner_accuracy * violation, 0.3 * tolerance))
          {
            if (updates == max_updates)
              break;
            multipliers_ = force;
            ++updates;
            continue;
          }

        const ContactState before = state;
        effort.krylov_iterations += system_.solve(
          state, linearize(state.w), [&](const NewtonSystem::Progress &now) {
            return now.reduction <= linear_accuracy;
          });
        ++effort.newton_steps;
        // near the end the slope is rounding: then the residual decides
        if (!search(state, before) &&
            ContactResidual(problem_, state, qp::SlipBound::given(slip_bound_)).value() >
              residual.value())
          {
            state = before;
            break;
          }
      }
    return effort;
  }
} // namespace stiction
