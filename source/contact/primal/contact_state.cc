#include <stiction/contact/primal/contact_state.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction
{
  ContactState::ContactState(const ContactLevel &problem)
    : u(problem.mesh().zero_vector<double>())
    , distances(Eigen::VectorXd::Zero(problem.motion().n_pressed()))
    , R(problem.mesh().zero_vector<double>())
  {
  }

  void ContactState::update(const ContactLevel &problem)
  {
    problem.apply_stiffness(R, u);
    R.sadd(-1., 1., problem.load());
    lambda = problem.B().contact_forces(R);
    w      = problem.penetration_and_slip(u, distances);
  }

  double ContactState::release_open_nodes(const ContactLevel &problem,
                                          const qp::Scaling &scaling)
  {
    double released = 0.;
    for (Eigen::Index i = 0; i < problem.n_nodes(); ++i)
      if (lambda(i) / scaling.force(i) < -w(i) / scaling.displacement_at(i) &&
          problem.slip_bound().constant()(i) == 0.)
        {
          const ContactFrame &frame = problem.B().frames()[i];
          released += at_node(lambda, i).cwiseProduct(frame.scales()).norm();
          set_at_node(lambda, i, Eigen::Vector3d::Zero());
        }
    return released;
  }

  void ContactState::go_back(const ContactState &before, const double part)
  {
    u.sadd(part, 1. - part, before.u);
    R.sadd(part, 1. - part, before.R);
    distances = part * distances + (1. - part) * before.distances;
    lambda    = part * lambda + (1. - part) * before.lambda;
    w         = part * w + (1. - part) * before.w;
  }

  ContactResidual::ContactResidual(const ContactLevel &problem, const ContactState &state,
                                   const qp::SlipBound &slip_bound)
    : ContactResidual(problem, state, slip_bound,
                      problem.scales(state.u, state.R, state.lambda))
  {
  }

  ContactResidual::ContactResidual(const ContactLevel &problem, const ContactState &state,
                                   const qp::SlipBound &slip_bound,
                                   const ContactLevel::Scales &scales)
    : force_scale(scales.force)
    , conditions(state.lambda, -state.w, slip_bound.at(state.lambda), scales.scaling)
    , equilibrium(problem.sum_of_norms_inside(state.R) / scales.force)
    , obstacle_force(problem.motion().force_error(state.lambda))
  {
  }

  double ContactResidual::value() const
  {
    double largest = std::max(equilibrium, obstacle_force);
    for (const auto &figure : conditions.deciding_figures())
      {
        if (!std::isfinite(figure.second))
          return std::numeric_limits<double>::infinity();
        largest = std::max(largest, figure.second);
      }
    return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
  }
} // namespace stiction
