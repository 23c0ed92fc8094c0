#include <stiction/qp/sets/contact_linearization.h>
#include <stiction/qp/sets/slip_bound.h>

#include <cmath>

namespace stiction::qp
{
  ContactLinearization::ContactLinearization(const Eigen::VectorXd &x,
                                             const Eigen::VectorXd &gradient,
                                             const Eigen::VectorXd &rho,
                                             const SlipBound &slip_bound)
    : m_(slip_bound.n_nodes())
    , has_normal_(x.size() == 3 * m_)
    , t1_(has_normal_ ? m_ : 0)
    , t2_(t1_ + m_)
    , prescribed_(Eigen::VectorXd::Zero(x.size()))
  {
    Eigen::VectorXd a = x - rho.replicate(x.size() / m_, 1).cwiseProduct(gradient);
    const Eigen::VectorXd radius = slip_bound.at(a);
    const Eigen::VectorXd target = slip_bound.at(x);

    std::vector<double> curvature;
    const auto add = [&](const Eigen::Index i, const Eigen::Vector3d &direction,
                         const Eigen::Vector2d &follows, const double mu) {
      free_.push_back({i, direction, follows});
      curvature.push_back(mu);
    };

    double square = 0.;
    for (Eigen::Index i = 0; i < m_; ++i)
      {
        const Eigen::Vector2d x_t(x(i + t1_), x(i + t2_));
        const Eigen::Vector2d a_t(a(i + t1_), a(i + t2_));
        const double norm = a_t.norm();

        const bool is_pressed      = a(i) > 0. || slip_bound.is_tied(i);
        const double normal_change = has_normal_ ? x(i) - (is_pressed ? a(i) : 0.) : 0.;
        const Eigen::Vector2d tangential_change =
          x_t - (norm > radius(i) ? radius(i) / norm * a_t : a_t);
        square += normal_change * normal_change + tangential_change.squaredNorm();

        Eigen::Vector2d follows = Eigen::Vector2d::Zero();
        if (radius(i) == 0.)
          {
            prescribed_(i + t1_) = -x_t(0);
            prescribed_(i + t2_) = -x_t(1);
          }
        else if (norm <= radius(i))
          {
            add(i, Eigen::Vector3d::UnitY(), follows, 0.);
            add(i, Eigen::Vector3d::UnitZ(), follows, 0.);
          }
        else
          {
            const Eigen::Vector2d n = a_t / norm;
            const Eigen::Vector2d d = target(i) * n - x_t;
            prescribed_(i + t1_)    = d(0);
            prescribed_(i + t2_)    = d(1);
            follows                 = slip_bound.coefficient()(i) * n;
            add(i, Eigen::Vector3d(0., -n(1), n(0)), Eigen::Vector2d::Zero(),
                (norm - radius(i)) / (rho(i) * radius(i)));
          }

        if (!has_normal_)
          continue;
        if (is_pressed)
          add(i, Eigen::Vector3d::UnitX(), follows, 0.);
        else
          prescribed_(i) = -x(i);
      }
    residual_  = std::sqrt(square);
    curvature_ = Eigen::Map<const Eigen::VectorXd>(
      curvature.data(), static_cast<Eigen::Index>(curvature.size()));
  }

  Eigen::VectorXd ContactLinearization::embed(const Eigen::VectorXd &y) const
  {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(prescribed_.size());
    for (Eigen::Index k = 0; k < n_free(); ++k)
      {
        const Free &f = free_[k];
        if (has_normal_)
          d(f.node) += f.direction(0) * y(k);
        d(f.node + t1_) += (f.direction(1) + f.follows(0)) * y(k);
        d(f.node + t2_) += (f.direction(2) + f.follows(1)) * y(k);
      }
    return d;
  }

  Eigen::VectorXd ContactLinearization::test(const Eigen::VectorXd &v) const
  {
    Eigen::VectorXd y(n_free());
    for (Eigen::Index k = 0; k < n_free(); ++k)
      {
        const Free &f = free_[k];
        y(k)          = (has_normal_ ? f.direction(0) * v(f.node) : 0.) +
               f.direction(1) * v(f.node + t1_) + f.direction(2) * v(f.node + t2_);
      }
    return y;
  }

  Eigen::VectorXd ContactLinearization::transpose_embed(const Eigen::VectorXd &v) const
  {
    Eigen::VectorXd y = test(v);
    for (Eigen::Index k = 0; k < n_free(); ++k)
      y(k) += free_[k].follows(0) * v(free_[k].node + t1_) +
              free_[k].follows(1) * v(free_[k].node + t2_);
    return y;
  }
} // namespace stiction::qp
