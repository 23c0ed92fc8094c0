#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/central_path.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

#include "second_order_cone.h"

namespace stiction::qp
{
  using Eigen::Matrix3d;
  using Eigen::Vector2d;
  using Eigen::Vector3d;
  using Eigen::VectorXd;

  CentralPath::CentralPath(const SlipBound &slip_bound, const Scaling &scaling)
    : slip_bound_(slip_bound)
    , scaling_(scaling)
    , m_(slip_bound.n_nodes())
    , lambda_(VectorXd::Zero(3 * m_))
    , w_(lambda_)
    , sigma_(VectorXd::Zero(m_))
    , lambda_change_(lambda_)
    , w_change_(lambda_)
    , sigma_change_(sigma_)
    , changes_(m_)
  {
    for (Eigen::Index i = 0; i < m_; ++i)
      if (!slip_bound.is_tied(i))
        {
          bounded_.push_back(i);
          lambda_(i) = scaling.force(i);
        }
  }

  void CentralPath::open_gaps(const VectorXd &gradient)
  {
    double large = 1.;
    for (Eigen::Index i = 0; i < m_; ++i)
      large = std::max(large, at_node(gradient, i).norm() / scaling_.displacement_at(i));
    for (const Eigen::Index i : bounded_)
      {
        w_(i) = large * scaling_.displacement_at(i);
        if (has_friction(i))
          sigma_(i) = lambda_(i) * w_(i) / force(i).cone(0);
      }
  }

  void CentralPath::begin_near(const VectorXd &lambda, const VectorXd &w,
                               const double residual)
  {
    const double mu = std::pow(std::max(residual, least_residual), 2) * unit();
    for (const Eigen::Index i : bounded_)
      {
        const double force = scaling_.force(i), way = scaling_.displacement_at(i);
        // λ/force − w/way remains what it is
        const Vector3d a  = at_node(lambda, i) / force - at_node(w, i) / way;
        const double part = mu / (force * way);
        const double longer =
          0.5 * (std::abs(a(0)) + std::hypot(a(0), 2. * std::sqrt(part)));
        lambda_(i) = force * (a(0) > 0. ? longer : part / longer);
        w_(i)      = mu / lambda_(i);
        if (has_friction(i))
          begin_near_with_friction(i, a.tail<2>(), mu);
      }
  }

  // With e along a, λ_t = κ g e and w_t = −κ σ e are central for all κ < 1 where
  // σ = μ/(g (1 − κ²)).
  void CentralPath::begin_near_with_friction(const Eigen::Index i, const Vector2d &a,
                                             const double mu)
  {
    const double g = force(i).cone(0);
    double kappa = 0., beyond = 1.;
    for (unsigned int halvings = 0; halvings < 50; ++halvings)
      {
        const double middle = 0.5 * (kappa + beyond);
        const double length =
          middle * (g / scaling_.force(i) +
                    mu / (g * (1. - middle * middle) * scaling_.displacement_at(i)));
        (length < a.norm() ? kappa : beyond) = middle;
      }
    sigma_(i)        = mu / (g * (1. - kappa * kappa));
    const Vector2d e = a.normalized();
    set_at_node(lambda_, i, {lambda_(i), kappa * g * e(0), kappa * g * e(1)});
    set_at_node(w_, i, {w_(i), -kappa * sigma_(i) * e(0), -kappa * sigma_(i) * e(1)});
  }

  double CentralPath::unit() const
  {
    double sum = 0.;
    for (Eigen::Index i = 0; i < m_; ++i)
      sum += scaling_.force(i) * scaling_.displacement_at(i);
    return sum / static_cast<double>(m_);
  }

  bool CentralPath::has_friction(const Eigen::Index i) const
  {
    return !slip_bound_.is_frictionless(i);
  }

  CentralPath::ConePoint CentralPath::force(const Eigen::Index i) const
  {
    return {lambda_(i),
            {slip_bound_.constant()(i) + slip_bound_.coefficient()(i) * lambda_(i),
             lambda_(i + m_), lambda_(i + 2 * m_)}};
  }

  CentralPath::ConePoint CentralPath::force_change(const Eigen::Index i) const
  {
    return {lambda_change_(i),
            {slip_bound_.coefficient()(i) * lambda_change_(i), lambda_change_(i + m_),
             lambda_change_(i + 2 * m_)}};
  }

  CentralPath::ConePoint CentralPath::dual(const Eigen::Index i) const
  {
    return {w_(i), {sigma_(i), w_(i + m_), w_(i + 2 * m_)}};
  }

  CentralPath::ConePoint CentralPath::dual_change(const Eigen::Index i) const
  {
    return {w_change_(i), {sigma_change_(i), w_change_(i + m_), w_change_(i + 2 * m_)}};
  }

  // λ_ν w_ν and (g, λ_t)∘(σ, w_t)
  CentralPath::ConePoint CentralPath::product(const ConePoint &force,
                                              const ConePoint &dual)
  {
    return {force.normal * dual.normal, product_with(force.cone) * dual.cone};
  }

  double CentralPath::mean_product(const double length) const
  {
    double sum = 0., n = 0.;
    for (const Eigen::Index i : bounded_)
      {
        const ConePoint p = force(i), dp = force_change(i);
        const ConePoint d = dual(i), dd = dual_change(i);
        sum += (p.normal + length * dp.normal) * (d.normal + length * dd.normal);
        ++n;
        if (has_friction(i))
          {
            sum += (p.cone + length * dp.cone).dot(d.cone + length * dd.cone);
            ++n;
          }
      }
    return n > 0. ? sum / n : 0.;
  }

  double CentralPath::centring() const
  {
    const double mu = mean_product();
    return mu > 0.
             ? std::pow(std::max(mean_product(std::min(1., largest_step())) / mu, 0.), 3)
             : 0.;
  }

  void CentralPath::aim(const double mu)
  {
    for (const Eigen::Index i : bounded_)
      {
        const ConePoint now = product(force(i), dual(i));
        changes_[i]         = {mu - now.normal, mu * Vector3d::UnitX() - now.cone};
      }
  }

  void CentralPath::aim_with_correction(const double mu)
  {
    aim(mu);
    for (const Eigen::Index i : bounded_)
      {
        const ConePoint missed = product(force_change(i), dual_change(i));
        changes_[i].normal -= missed.normal;
        changes_[i].cone -= missed.cone;
      }
  }

  Matrix3d CentralPath::compliance(const Eigen::Index i) const
  {
    Matrix3d D = Matrix3d::Zero();
    if (slip_bound_.is_tied(i))
      return D;
    const ConePoint p = force(i), d = dual(i);
    if (has_friction(i))
      {
        Matrix3d follows = Matrix3d::Identity();
        follows(0, 0)    = slip_bound_.coefficient()(i);
        D = product_with(p.cone).inverse() * product_with(d.cone) * follows;
      }
    D.row(0) << d.normal / p.normal, 0., 0.;
    return D;
  }

  VectorXd CentralPath::right_hand_side() const
  {
    VectorXd c = VectorXd::Zero(3 * m_);
    for (const Eigen::Index i : bounded_)
      {
        const ConePoint p = force(i);
        Vector3d c_i      = Vector3d::Zero();
        if (has_friction(i))
          c_i = product_with(p.cone).inverse() * changes_[i].cone;
        c_i(0) = changes_[i].normal / p.normal;
        set_at_node(c, i, c_i);
      }
    return c;
  }

  void CentralPath::set_direction(const VectorXd &lambda_change, const VectorXd &w_change)
  {
    lambda_change_ = lambda_change;
    for (const Eigen::Index i : bounded_)
      {
        set_at_node(w_change_, i, at_node(w_change, i));
        if (!has_friction(i))
          {
            for (const Eigen::Index t : {i + m_, i + 2 * m_})
              lambda_change_(t) = w_change_(t) = 0.;
            continue;
          }
        const ConePoint p = force(i);
        sigma_change_(i) = (changes_[i].cone(0) - dual(i).cone.dot(force_change(i).cone) -
                            p.cone.tail<2>().dot(dual_change(i).cone.tail<2>())) /
                           p.cone(0);
      }
  }

  double CentralPath::largest_step() const
  {
    double step = std::numeric_limits<double>::infinity();
    for (const Eigen::Index i : bounded_)
      {
        const ConePoint p = force(i), dp = force_change(i);
        const ConePoint d = dual(i), dd = dual_change(i);
        step = std::min(
          {step, step_to_zero(p.normal, dp.normal), step_to_zero(d.normal, dd.normal)});
        if (has_friction(i))
          step = std::min(
            {step, step_to_cone(p.cone, dp.cone), step_to_cone(d.cone, dd.cone)});
      }
    return step;
  }

  void CentralPath::advance(const double length)
  {
    lambda_ += length * lambda_change_;
    w_ += length * w_change_;
    sigma_ += length * sigma_change_;
  }

  VectorXd CentralPath::lambda_on_boundary() const
  {
    VectorXd y = lambda_;
    for (const Eigen::Index i : bounded_)
      if (lambda_(i) / scaling_.force(i) < w_(i) / scaling_.displacement_at(i))
        y(i) = 0.;
    const VectorXd bound = slip_bound_.at(y);
    for (const Eigen::Index i : bounded_)
      {
        const Vector3d p = force(i).cone;
        const double t   = p.tail<2>().norm();
        const bool slips = (p(0) - t) / scaling_.force(i) <
                           dual(i).cone.tail<2>().norm() / scaling_.displacement_at(i);
        if (t > bound(i) || (slips && t > 0.))
          for (const Eigen::Index k : {i + m_, i + 2 * m_})
            y(k) *= bound(i) / t;
      }
    return y;
  }
} // namespace stiction::qp
