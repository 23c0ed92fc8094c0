#include <stiction/contact/primal/primal_active_set.h>
#include <stiction/qp/sets/slip_bound.h>

#include <cmath>

namespace stiction
{
  PrimalActiveSet::PrimalActiveSet(const Eigen::VectorXd &lambda,
                                   const Eigen::VectorXd &w, const Eigen::VectorXd &rho,
                                   const qp::SlipBound &slip_bound)
    : nodes(rho.size())
  {
    const Eigen::Index m     = rho.size();
    const Eigen::VectorXd a  = lambda + rho.replicate(3, 1).cwiseProduct(w);
    const Eigen::VectorXd b  = slip_bound.at(a);
    const Eigen::Matrix3d nn = Eigen::Vector3d::UnitX().asDiagonal();

    for (Eigen::Index i = 0; i < m; ++i)
      {
        Node &node = nodes[i];
        if (a(i) > 0.)
          {
            node.projection -= nn;
            node.shift(0) = -w(i);
          }
        node.test = node.projection;

        const Eigen::Vector2d a_t(a(i + m), a(i + 2 * m));
        const double norm = a_t.norm();
        if (b(i) > 0. && norm <= b(i))
          {
            node.projection.bottomRightCorner<2, 2>().setZero();
            node.test.bottomRightCorner<2, 2>().setZero();
            node.shift(1) = -w(i + m);
            node.shift(2) = -w(i + 2 * m);
          }
        else if (b(i) > 0.)
          {
            const Eigen::Vector2d t = a_t / norm;
            const Eigen::Vector2d across(-t(1), t(0));
            node.spring.bottomRightCorner<2, 2>() =
              rho(i) * b(i) / (norm - b(i)) * across * across.transpose();
            node.test.bottomLeftCorner<2, 1>() = -slip_bound.coefficient()(i) * t;
            node.load.tail<2>()                = slip_bound.constant()(i) * t;
          }
      }
  }
} // namespace stiction
