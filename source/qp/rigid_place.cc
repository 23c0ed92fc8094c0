#include <stiction/qp/rigid_place.h>
#include <stiction/qp/sets/feasible_set.h>

#include <Eigen/Cholesky>

#include <algorithm>

namespace stiction::qp
{
  namespace
  {
    // Of the loads: what may be out of balance at a start.
    constexpr double balanced = 1e-3;

    // Of the softest spring: what holds motions that no spring holds, anew in each step.
    constexpr double least_stiffness = 1e-4;

    constexpr unsigned int max_steps = 60, max_halvings = 60;

    class SpringEnergy
    {
    public:
      SpringEnergy(const EqualityConstraint &constraint, const Eigen::VectorXd &gradient,
                   const Eigen::VectorXd &stiffness, const SlipBound &slip_bound)
        : G_(constraint.G)
        , e_(constraint.e)
        , start_(gradient)
        , rho_(stiffness)
        , is_rough_(slip_bound.constant().array() > 0. ||
                    slip_bound.coefficient().array() > 0.)
        , is_tied_(slip_bound.constant().array() == tied)
      {
      }

      // The derivative.
      Eigen::VectorXd slope(const Eigen::VectorXd &alpha) const
      {
        return e_ - G_.transpose() * forces(alpha);
      }

      // λ of the springs.
      Eigen::VectorXd forces(const Eigen::VectorXd &alpha) const
      {
        const Eigen::Index m = rho_.size();
        Eigen::VectorXd lambda(3 * m);
        const Eigen::VectorXd r = start_ + G_ * alpha;
        for (Eigen::Index i = 0; i < m; ++i)
          {
            const bool is_closed = r(i) < 0. || is_tied_(i);
            const bool sticks    = is_closed && is_rough_(i);
            lambda(i)            = is_closed ? -rho_(i) * r(i) : 0.;
            for (const Eigen::Index k : {i + m, i + 2 * m})
              lambda(k) = sticks ? -rho_(i) * r(k) : 0.;
          }
        return lambda;
      }

      // The second derivative, with a little at every motion.
      Eigen::MatrixXd curvature(const Eigen::VectorXd &alpha) const
      {
        const Eigen::Index m        = rho_.size();
        const Eigen::VectorXd depth = -(start_ + G_ * alpha).head(m);
        Eigen::MatrixXd H           = least_stiffness * rho_.minCoeff() *
                            Eigen::MatrixXd::Identity(e_.size(), e_.size());
        for (Eigen::Index i = 0; i < m; ++i)
          if (depth(i) > 0. || is_tied_(i))
            for (Eigen::Index c = 0; c < (is_rough_(i) ? 3 : 1); ++c)
              H.noalias() += rho_(i) * G_.row(i + c * m).transpose() * G_.row(i + c * m);
        return H;
      }

    private:
      const Eigen::MatrixXd &G_;
      const Eigen::VectorXd &e_;
      const Eigen::VectorXd &start_;
      const Eigen::VectorXd &rho_;
      const Eigen::Array<bool, Eigen::Dynamic, 1> is_rough_, is_tied_;
    };
  } // namespace

  RigidPlace rigid_place(const EqualityConstraint &constraint,
                         const Eigen::VectorXd &gradient,
                         const Eigen::VectorXd &stiffness, const SlipBound &slip_bound)
  {
    const SpringEnergy energy(constraint, gradient, stiffness, slip_bound);
    Eigen::VectorXd alpha = Eigen::VectorXd::Zero(constraint.e.size());
    for (unsigned int k = 0; k < max_steps; ++k)
      {
        const Eigen::VectorXd slope = energy.slope(alpha);
        const double size =
          std::max(constraint.e.norm(),
                   energy.forces(alpha).head(stiffness.size()).cwiseAbs().sum());
        if (slope.norm() <= balanced * size)
          break;
        const Eigen::VectorXd step = energy.curvature(alpha).llt().solve(-slope);
        // the energy falls along the step up to where its slope is zero
        double low = 0., high = 1., part = 1.;
        for (unsigned int h = 0; h < max_halvings; ++h)
          {
            const bool rises = energy.slope(alpha + part * step).dot(step) > 0.;
            if (part == 1. && !rises)
              break;
            (rises ? high : low) = part;
            part                 = 0.5 * (low + high);
          }
        alpha += part * step;
      }
    Eigen::VectorXd lambda = energy.forces(alpha);
    project(lambda, slip_bound);
    return {alpha, lambda};
  }
} // namespace stiction::qp
