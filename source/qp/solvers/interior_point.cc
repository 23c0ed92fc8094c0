#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/interior_point.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "second_order_cone.h"

namespace stiction::qp
{
  namespace
  {
    using Eigen::Matrix3d;
    using Eigen::Vector3d;
    using Eigen::VectorXd;

    // The part of the way to the boundary that a step goes at least.
    constexpr double shortest_part = 0.9;

    // Steps without a new smallest residual before giving up.
    constexpr unsigned int max_steps_without_progress = 10;

  } // namespace

  // The iterate: x, its gradient and the duals of all nodes, and a direction.
  class InteriorPoint::Path
  {
  public:
    Path(const Eigen::MatrixXd &Q, const SlipBound &slip_bound, const Scaling &scaling,
         const VectorXd &x, const VectorXd &gradient);

    // A predictor step and a corrector; false if it has no length.
    bool step();

    // The point, and it with forces that are zero where gaps are open and on
    // their circle where there is slip: what it approaches from inside.
    const VectorXd &point() const { return x_; }
    VectorXd point_on_boundary() const;

    const VectorXd &gradient() const { return gradient_; }

  private:
    // What a node has of forces, or of their duals: an element of the half line
    // and one of the second-order cone, (bound; two tangential components).
    struct ConePoint
    {
      double normal = 0.;
      Vector3d cone = Vector3d::Zero();
    };

    // Forces with their bound, and the change of both in the direction.
    ConePoint force(const Eigen::Index i) const
    {
      return {x_(i),
              {slip_bound_.constant()(i) + slip_bound_.coefficient()(i) * x_(i),
               x_(i + m_), x_(i + 2 * m_)}};
    }
    ConePoint force_change(const Eigen::Index i) const
    {
      return {d_(i), {slip_bound_.coefficient()(i) * d_(i), d_(i + m_), d_(i + 2 * m_)}};
    }

    bool has_friction(const Eigen::Index i) const
    {
      return !slip_bound_.is_frictionless(i);
    }

    // λ_ν w_ν and (g, λ_t)∘(σ, w_t) of a node.
    static ConePoint product(const ConePoint &force, const ConePoint &dual)
    {
      return {force.normal * dual.normal, product_with(force.cone) * dual.cone};
    }

    // μ after a step of a given length in the direction.
    double mean_product(double length) const;

    // LU factors of the Newton matrix.
    void factorize();

    // The direction in which all products change by these amounts, up to first
    // order, and w becomes the gradient.
    void find_direction(const std::vector<ConePoint> &changes);

    // The length at which the direction leaves the cones.
    double largest_step() const;

    const Eigen::MatrixXd &Q_;
    const SlipBound &slip_bound_;
    const Scaling &scaling_;
    const Eigen::Index m_;
    std::vector<Eigen::Index> bounded_; // nodes that are not tied
    VectorXd x_, gradient_;
    std::vector<ConePoint> duals_, dual_changes_;
    double scale_; // of μ
    VectorXd d_, Qd_;
    VectorXd unit_; // of each unknown, for the factors
    Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  };

  InteriorPoint::Path::Path(const Eigen::MatrixXd &Q, const SlipBound &slip_bound,
                            const Scaling &scaling, const VectorXd &x,
                            const VectorXd &gradient)
    : Q_(Q)
    , slip_bound_(slip_bound)
    , scaling_(scaling)
    , m_(slip_bound.n_nodes())
    , x_(VectorXd::Zero(x.size()))
    , duals_(m_)
    , dual_changes_(m_)
    , d_(VectorXd::Zero(x.size()))
    , unit_(x.size())
  {
    for (Eigen::Index i = 0; i < m_; ++i)
      if (!slip_bound.is_tied(i))
        {
          bounded_.push_back(i);
          x_(i) = scaling.force(i);
        }
    gradient_ = gradient + Q_ * (x_ - x);

    // on the central path of a problem whose gradient is as large
    scale_       = 0.;
    double large = 1.;
    for (Eigen::Index i = 0; i < m_; ++i)
      {
        const double u = scaling.displacement_at(i);
        large          = std::max(large, at_node(gradient_, i).norm() / u);
        scale_ += scaling.force(i) * u / static_cast<double>(m_);
      }
    for (const Eigen::Index i : bounded_)
      {
        const ConePoint p = force(i);
        duals_[i].normal  = large * scaling.displacement_at(i);
        if (has_friction(i))
          duals_[i].cone(0) = p.normal * duals_[i].normal / p.cone(0);
      }
  }

  bool InteriorPoint::Path::step()
  {
    factorize();
    const double mu = mean_product(0.);
    std::vector<ConePoint> changes(m_);
    for (Eigen::Index i = 0; i < m_; ++i)
      {
        const ConePoint now = product(force(i), duals_[i]);
        changes[i]          = {-now.normal, -now.cone};
      }
    find_direction(changes);

    // what is missing to first order, and to where the prediction says
    const double predicted = mean_product(std::min(1., largest_step()));
    const double centre = mu > 0. ? mu * std::pow(std::max(predicted / mu, 0.), 3) : 0.;
    for (Eigen::Index i = 0; i < m_; ++i)
      {
        const ConePoint missed = product(force_change(i), dual_changes_[i]);
        changes[i].normal += centre - missed.normal;
        changes[i].cone += centre * Vector3d::UnitX() - missed.cone;
      }
    find_direction(changes);

    const double part   = std::max(shortest_part, 1. - mu / scale_);
    const double length = std::min(1., part * largest_step());
    if (!(length > 0.) || !d_.allFinite())
      return false;
    x_ += length * d_;
    gradient_ += length * Qd_;
    for (Eigen::Index i = 0; i < m_; ++i)
      {
        duals_[i].normal += length * dual_changes_[i].normal;
        duals_[i].cone += length * dual_changes_[i].cone;
      }
    return true;
  }

  double InteriorPoint::Path::mean_product(const double length) const
  {
    double sum = 0., n = 0.;
    for (const Eigen::Index i : bounded_)
      {
        ConePoint p = force(i), d = duals_[i];
        if (length > 0.)
          {
            p.normal += length * force_change(i).normal;
            p.cone += length * force_change(i).cone;
            d.normal += length * dual_changes_[i].normal;
            d.cone += length * dual_changes_[i].cone;
          }
        sum += p.normal * d.normal;
        ++n;
        if (has_friction(i))
          {
            sum += p.cone.dot(d.cone);
            ++n;
          }
      }
    return n > 0. ? sum / n : 0.;
  }

  void InteriorPoint::Path::factorize()
  {
    Eigen::MatrixXd A = Q_;
    for (const Eigen::Index i : bounded_)
      {
        const std::array<Eigen::Index, 3> k = {i, i + m_, i + 2 * m_};
        const ConePoint p                   = force(i);
        A(i, i) += duals_[i].normal / p.normal;
        if (!has_friction(i))
          for (const Eigen::Index t : {k[1], k[2]})
            {
              A.row(t).setZero();
              A.col(t).setZero();
              A(t, t) = Q_(t, t);
            }
        else
          {
            Matrix3d follows = Matrix3d::Identity();
            follows(0, 0)    = slip_bound_.coefficient()(i);
            const Matrix3d block =
              product_with(p.cone).inverse() * product_with(duals_[i].cone) * follows;
            for (int r = 1; r < 3; ++r)
              for (int c = 0; c < 3; ++c)
                A(k[r], k[c]) += block(r, c);
          }
      }
    unit_ = A.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    lu_.compute(unit_.asDiagonal() * A * unit_.asDiagonal());
  }

  void InteriorPoint::Path::find_direction(const std::vector<ConePoint> &changes)
  {
    // without bounds the step is Newton's
    VectorXd right_hand_side = -gradient_;
    for (const Eigen::Index i : bounded_)
      {
        const ConePoint p  = force(i);
        const Vector3d w   = at_node(gradient_, i);
        right_hand_side(i) = changes[i].normal / p.normal - (w(0) - duals_[i].normal);
        right_hand_side(i + m_) = right_hand_side(i + 2 * m_) = 0.;
        if (!has_friction(i))
          continue;
        const Vector3d t =
          product_with(p.cone).inverse() * changes[i].cone - (w - duals_[i].cone);
        right_hand_side(i + m_)     = t(1);
        right_hand_side(i + 2 * m_) = t(2);
      }
    d_            = unit_.cwiseProduct(lu_.solve(unit_.cwiseProduct(right_hand_side)));
    Qd_.noalias() = Q_ * d_;

    for (const Eigen::Index i : bounded_)
      {
        const Vector3d w  = at_node(gradient_, i) + at_node(Qd_, i);
        const ConePoint p = force(i), dp = force_change(i);
        ConePoint &change = dual_changes_[i];
        change.normal     = w(0) - duals_[i].normal;
        if (!has_friction(i))
          continue;
        change.cone    = w - duals_[i].cone;
        change.cone(0) = (changes[i].cone(0) - duals_[i].cone.dot(dp.cone) -
                          p.cone.tail<2>().dot(change.cone.tail<2>())) /
                         p.cone(0);
      }
  }

  double InteriorPoint::Path::largest_step() const
  {
    double step = std::numeric_limits<double>::infinity();
    for (const Eigen::Index i : bounded_)
      {
        const ConePoint p = force(i), dp = force_change(i);
        step = std::min({step, step_to_zero(p.normal, dp.normal),
                         step_to_zero(duals_[i].normal, dual_changes_[i].normal)});
        if (has_friction(i))
          step = std::min({step, step_to_cone(p.cone, dp.cone),
                           step_to_cone(duals_[i].cone, dual_changes_[i].cone)});
      }
    return step;
  }

  VectorXd InteriorPoint::Path::point_on_boundary() const
  {
    VectorXd y = x_;
    for (const Eigen::Index i : bounded_)
      if (x_(i) / scaling_.force(i) < duals_[i].normal / scaling_.displacement_at(i))
        y(i) = 0.;
    const VectorXd bound = slip_bound_.at(y);
    for (const Eigen::Index i : bounded_)
      {
        const Vector3d p = force(i).cone;
        const double t   = p.tail<2>().norm();
        const bool slips = (p(0) - t) / scaling_.force(i) <
                           duals_[i].cone.tail<2>().norm() / scaling_.displacement_at(i);
        if (t > bound(i) || (slips && t > 0.))
          for (const Eigen::Index k : {i + m_, i + 2 * m_})
            y(k) *= bound(i) / t;
      }
    return y;
  }

  InteriorPoint::InteriorPoint(const Eigen::MatrixXd &Q)
    : Q_(Q)
  {
  }

  SolverRun InteriorPoint::solve(VectorXd &x, VectorXd &gradient,
                                 const SlipBound &slip_bound, const Scaling &scaling,
                                 const double tolerance, const unsigned int max_steps,
                                 const Observer &observer) const
  {
    SolverRun statistics;
    statistics.residual       = natural_residual(x, gradient, slip_bound, scaling);
    double smallest           = std::numeric_limits<double>::infinity(); // of the path
    const auto keep_if_better = [&](const VectorXd &y, const VectorXd &Qy_h) {
      const double residual = natural_residual(y, Qy_h, slip_bound, scaling);
      smallest              = std::min(smallest, residual);
      if (!(residual < statistics.residual))
        return;
      x                   = y;
      gradient            = Qy_h;
      statistics.residual = residual;
    };

    Path path(Q_, slip_bound, scaling, x, gradient);
    for (unsigned int idle = 0; statistics.residual > tolerance &&
                                statistics.interior_point_steps < max_steps &&
                                idle < max_steps_without_progress;)
      {
        if (!path.step())
          break;
        ++statistics.interior_point_steps;
        const double before = smallest;
        keep_if_better(path.point(), path.gradient());
        const VectorXd y = path.point_on_boundary();
        keep_if_better(y, path.gradient() + Q_ * (y - path.point()));
        idle = smallest < 0.9 * before ? 0 : idle + 1;
        observer(statistics.interior_point_steps, smallest);
      }
    statistics.converged = statistics.residual <= tolerance;
    return statistics;
  }
} // namespace stiction::qp
