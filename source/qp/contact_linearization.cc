#include <stiction/qp/contact_linearization.h>
#include <stiction/qp/slip_bound.h>

#include <algorithm>
#include <cmath>

namespace stiction::qp
{
  ContactLinearization::ContactLinearization(const Eigen::VectorXd &x,
                                             const Eigen::VectorXd &gradient,
                                             const Eigen::VectorXd &rho,
                                             const SlipBound &slip_bound)
    : m_(slip_bound.n_nodes())
    , prescribed_(Eigen::VectorXd::Zero(3 * m_))
  {
    Eigen::VectorXd a = x - rho.replicate(3, 1).cwiseProduct(gradient);
    const Eigen::VectorXd radius = slip_bound.at(a);
    const Eigen::VectorXd target = slip_bound.at(x);

    std::vector<double> curvature;
    const auto add = [&](const Eigen::Index i,
                         const Eigen::Vector3d &direction,
                         const Eigen::Vector2d &follows,
                         const double mu) {
      free_.push_back({i, direction, follows});
      curvature.push_back(mu);
    };

    double square = 0.;
    for (Eigen::Index i = 0; i < m_; ++i)
      {
        const Eigen::Vector2d x_t(x(i + m_), x(i + 2 * m_));
        const Eigen::Vector2d a_t(a(i + m_), a(i + 2 * m_));
        const double norm    = a_t.norm();
        const bool is_closed = a(i) > 0.;

        const double normal_change = x(i) - std::max(a(i), 0.);
        const Eigen::Vector2d tangential_change =
          x_t - (norm > radius(i) ? radius(i) / norm * a_t : a_t);
        square +=
          normal_change * normal_change + tangential_change.squaredNorm();

        Eigen::Vector2d follows = Eigen::Vector2d::Zero();
        if (radius(i) == 0.)
          {
            prescribed_(i + m_)     = -x_t(0);
            prescribed_(i + 2 * m_) = -x_t(1);
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
            prescribed_(i + m_)     = d(0);
            prescribed_(i + 2 * m_) = d(1);
            if (slip_bound.is_coulomb())
              follows = slip_bound.data()(i) * n;
            add(i,
                Eigen::Vector3d(0., -n(1), n(0)),
                Eigen::Vector2d::Zero(),
                (norm - radius(i)) / (rho(i) * radius(i)));
          }

        if (is_closed)
          add(i, Eigen::Vector3d::UnitX(), follows, 0.);
        else
          prescribed_(i) = -x(i);
      }
    residual_  = std::sqrt(square);
    curvature_ = Eigen::Map<const Eigen::VectorXd>(
      curvature.data(), static_cast<Eigen::Index>(curvature.size()));
  }



  Eigen::VectorXd
  ContactLinearization::embed(const Eigen::VectorXd &y) const
  {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(3 * m_);
    for (Eigen::Index k = 0; k < n_free(); ++k)
      {
        const Free &f = free_[k];
        d(f.node) += f.direction(0) * y(k);
        d(f.node + m_) += (f.direction(1) + f.follows(0)) * y(k);
        d(f.node + 2 * m_) += (f.direction(2) + f.follows(1)) * y(k);
      }
    return d;
  }



  Eigen::VectorXd
  ContactLinearization::test(const Eigen::VectorXd &v) const
  {
    Eigen::VectorXd y(n_free());
    for (Eigen::Index k = 0; k < n_free(); ++k)
      {
        const Free &f = free_[k];
        y(k) = f.direction(0) * v(f.node) + f.direction(1) * v(f.node + m_) +
               f.direction(2) * v(f.node + 2 * m_);
      }
    return y;
  }



  Eigen::VectorXd
  ContactLinearization::transpose_embed(const Eigen::VectorXd &v) const
  {
    Eigen::VectorXd y = test(v);
    for (Eigen::Index k = 0; k < n_free(); ++k)
      y(k) += free_[k].follows(0) * v(free_[k].node + m_) +
              free_[k].follows(1) * v(free_[k].node + 2 * m_);
    return y;
  }
} // namespace stiction::qp
