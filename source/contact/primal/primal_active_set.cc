#include <stiction/contact/primal/primal_active_set.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/sets/slip_bound.h>

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace stiction
{
  namespace
  {
    // Of ρ: a stiffer spring, at a node on the edge of sticking, would take all digits of
    // the preconditioner. The solution does not depend on it: there the force is along
    // the slip, and the spring is not strained.
    constexpr double stiffest_spring = 1e4;

    // Of all motions together: one that moves no contact node is not divided by nothing.
    constexpr double not_nothing = 1e-12;

    // Of the foundation: what holds a motion with less leaves it free.
    constexpr double no_stiffness = 1e-9;

    // Of the foundation: the softer, the less a step is short of Newton's in other
    // motions.
    constexpr double tether_stiffness = 0.01;
  } // namespace

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
        if (a(i) > 0. || slip_bound.is_tied(i))
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
            const double spring =
              rho(i) * std::min(b(i) / (norm - b(i)), stiffest_spring);
            node.spring.bottomRightCorner<2, 2>() = spring * across * across.transpose();
            node.test.bottomLeftCorner<2, 1>()    = -slip_bound.coefficient()(i) * t;
            node.load.tail<2>()                   = slip_bound.constant()(i) * t;
          }
      }
  }

  PrimalActiveSet::Resistance PrimalActiveSet::resistance(
    const Eigen::MatrixXd &motions, const Eigen::VectorXd &foundation) const
  {
    const Eigen::Index n = motions.cols();
    const auto m         = static_cast<Eigen::Index>(nodes.size());
    Eigen::MatrixXd held = Eigen::MatrixXd::Zero(n, n), all = held, at(3, n);
    for (Eigen::Index i = 0; i < m; ++i)
      {
        at << motions.row(i), motions.row(i + m), motions.row(i + 2 * m);
        const Eigen::Matrix3d M =
          foundation(i) * (Eigen::Matrix3d::Identity() - nodes[i].projection) +
          nodes[i].spring;
        held.noalias() += at.transpose() * M * at;
        all.noalias() += foundation(i) * at.transpose() * at;
      }
    all.diagonal().array() += not_nothing * all.trace();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(held, all);
    return {eigen.eigenvalues(), eigen.eigenvectors()};
  }

  void PrimalActiveSet::tether(const Eigen::MatrixXd &motions,
                               const Eigen::VectorXd &foundation,
                               const Eigen::VectorXd &w)
  {
    if (motions.cols() == 0 || resistance(motions, foundation).part(0) > no_stiffness)
      return;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const double spring = tether_stiffness * foundation(i);
        nodes[i].spring += spring * Eigen::Matrix3d::Identity();
        nodes[i].load -= spring * (at_node(w, i) + nodes[i].shift);
      }
  }
} // namespace stiction
