#include <stiction/contact/primal/contact_level.h>
#include <stiction/contact/primal/newton_system.h>
#include <stiction/contact/primal/primal_interior_point.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <Eigen/Dense>

#include <algorithm>

namespace stiction
{
  namespace
  {
    // Of the way to the boundary of the cones.
    constexpr double part_of_way = 0.95;

    // A linear system is solved until this part of what μ is, over its unit ...
    constexpr double accuracy_of_mu = 0.1;

    // ... or of the tolerance.
    constexpr double accuracy_of_tolerance = 0.1;

    // What a predictor is solved for, of μ: it aims at none.
    constexpr double mu_of_predictor = 0.1;

    // What a step makes of μ if its predictor tells nothing.
    constexpr double reduction_without_predictor = 0.2;

    constexpr unsigned int longest_path = 100; // steps

    // Steps in which μ hardly falls before giving up.
    constexpr unsigned int max_idle_steps = 10;

    // Steps in a row that gain nothing with systems solved badly: near the end springs
    // become too stiff for that, and Newton steps may go on.
    constexpr unsigned int max_lost_steps = 5;
  } // namespace

  PrimalInteriorPoint::PrimalInteriorPoint(const ContactLevel &problem,
                                           NewtonSystem &system,
                                           const ContactState &start,
                                           const double tolerance, const bool may_be_near)
    : problem_(problem)
    , system_(system)
    , state_(start)
    , best_(start)
    , start_(problem, start, problem.slip_bound())
    , best_residual_(start_.value())
    , tolerance_(tolerance)
    , path_(problem.slip_bound(), start_.conditions.scaling())
  {
    if (may_be_near && best_residual_ <= qp::CentralPath::near_residual)
      path_.begin_near(start.lambda, -start.w, best_residual_);
    else
      path_.open_gaps(-start.w);
  }

  PrimalActiveSet PrimalInteriorPoint::linearize() const
  {
    const Eigen::VectorXd c = path_.right_hand_side();
    PrimalActiveSet result(problem_.n_nodes());
    for (Eigen::Index i = 0; i < problem_.n_nodes(); ++i)
      {
        PrimalActiveSet::Node &node = result.nodes[i];
        if (problem_.slip_bound().is_tied(i))
          {
            node.projection.setZero();
            node.test.setZero();
            node.shift = -at_node(state_.w, i);
            continue;
          }
        // times the inverses of the normal and the tangential block of D
        const Eigen::Matrix3d D = path_.compliance(i);
        node.spring(0, 0)       = 1. / D(0, 0);
        if (path_.has_friction(i))
          {
            const Eigen::Matrix2d inverse         = D.bottomRightCorner<2, 2>().inverse();
            node.spring.bottomRightCorner<2, 2>() = inverse;
            node.test.bottomLeftCorner<2, 1>()    = inverse * D.bottomLeftCorner<2, 1>();
          }
        node.load = node.spring * (at_node(c, i) + at_node(path_.w(), i)) +
                    node.test * at_node(path_.lambda(), i);
      }
    return result;
  }

  bool PrimalInteriorPoint::step()
  {
    const ContactState before = state_;
    const double mu           = path_.mean_product();
    const bool was_accurate   = is_accurate_;
    path_.aim(0.);
    if (!find_direction(mu_of_predictor * mu))
      return false;
    const unsigned int iterations = krylov_iterations_;
    double target                 = mu; // it must not fall ahead of the equilibrium
    if (was_accurate)
      target *= is_accurate_ ? path_.centring() : reduction_without_predictor;
    if (was_accurate && is_accurate_)
      path_.aim_with_correction(target);
    else
      path_.aim(target);
    state_ = before;
    // a step that is not a whole one leaves some of μ, whatever its target
    const bool is_fine = find_direction(std::max(target, (1. - part_of_way) * mu));
    krylov_iterations_ += iterations;
    const double length = std::min(1., part_of_way * path_.largest_step());
    if (!(length > 0.) || !is_fine)
      return false;
    path_.advance(length);
    state_.go_back(before, length);
    return true;
  }

  bool PrimalInteriorPoint::find_direction(const double mu)
  {
    const PrimalActiveSet linearization = linearize();
    const Eigen::VectorXd &force        = start_.conditions.scaling().force;
    const double accuracy = std::max(accuracy_of_mu * std::min(mu / path_.unit(), 1.),
                                     accuracy_of_tolerance * tolerance_);
    is_accurate_          = false;
    krylov_iterations_ =
      system_.solve(state_, linearization, [&](const NewtonSystem::Progress &now) {
        const double error =
          std::max({now.residual / start_.force_scale,
                    largest_at_nodes(now.contact_residual, force),
                    problem_.motion().force_error(now.lambda - now.contact_residual)});
        is_accurate_ = error <= accuracy;
        return is_accurate_;
      });

    // W Δλ = S (c − Δ(gap, slip)), W being triangular
    const Eigen::VectorXd w_change = -state_.w - path_.w();
    const Eigen::VectorXd missing  = path_.right_hand_side() - w_change;
    const Eigen::VectorXd change =
      by_nodes(problem_.n_nodes(), [&](const Eigen::Index i) -> Eigen::Vector3d {
        const PrimalActiveSet::Node &node = linearization.nodes[i];
        return node.test.triangularView<Eigen::UnitLower>().solve(node.spring *
                                                                  at_node(missing, i));
      });
    path_.set_direction(change, w_change);
    return change.allFinite();
  }

  bool PrimalInteriorPoint::is_at_end() const
  {
    return best_residual_ <= tolerance_ || is_blocked_ || idle_ == max_idle_steps ||
           lost_ == max_lost_steps || n_steps_ == longest_path;
  }

  void PrimalInteriorPoint::solve(const double residual, const unsigned int max_steps,
                                  const Observer &observer)
  {
    for (unsigned int steps = 0;
         best_residual_ > residual && steps < max_steps && !is_at_end(); ++steps)
      {
        const double mu = path_.mean_product();
        is_blocked_     = !step();
        if (is_blocked_)
          break;
        ++n_steps_;
        const ContactResidual now(problem_, state_, problem_.slip_bound());
        lost_ = is_accurate_ ? 0 : lost_ + 1;
        if (now.value() < best_residual_)
          {
            best_residual_ = now.value();
            best_          = state_;
            lost_          = 0;
          }
        idle_ = path_.mean_product() < 0.9 * mu ? 0 : idle_ + 1;
        observer(krylov_iterations_, now);
      }
  }
} // namespace stiction
