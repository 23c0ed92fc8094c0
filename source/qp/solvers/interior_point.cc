#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/central_path.h>
#include <stiction/qp/solvers/interior_point.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <limits>

namespace stiction::qp
{
  namespace
  {
    using Eigen::Matrix3d;
    using Eigen::VectorXd;

    // The part of the way to the boundary that a step goes at least.
    constexpr double shortest_part = 0.9;

    // Steps without a new smallest residual before giving up.
    constexpr unsigned int max_steps_without_progress = 10;
  } // namespace

  // The iterate, a point of the central path, with its gradient Qx − h.
  class InteriorPoint::Path
  {
  public:
    Path(const Eigen::MatrixXd &Q, const SlipBound &slip_bound, const Scaling &scaling,
         const VectorXd &x, const VectorXd &gradient);

    // A predictor step and a corrector; false if it has no length.
    bool step();

    // The point, and the one on the boundary that it approaches.
    const VectorXd &point() const { return path_.lambda(); }
    VectorXd point_on_boundary() const { return path_.lambda_on_boundary(); }

    const VectorXd &gradient() const { return gradient_; }

  private:
    // LU factors of the Newton matrix Q + D.
    void factorize();

    // The direction to where the path aims, and w becomes the gradient.
    void find_direction();

    const Eigen::MatrixXd &Q_;
    CentralPath path_;
    VectorXd gradient_;
    VectorXd d_, Qd_;
    VectorXd unit_; // of each unknown, for the factors
    Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  };

  InteriorPoint::Path::Path(const Eigen::MatrixXd &Q, const SlipBound &slip_bound,
                            const Scaling &scaling, const VectorXd &x,
                            const VectorXd &gradient)
    : Q_(Q)
    , path_(slip_bound, scaling)
    , gradient_(gradient + Q * (path_.lambda() - x))
    , unit_(x.size())
  {
    path_.open_gaps(gradient_);
  }

  bool InteriorPoint::Path::step()
  {
    factorize();
    const double mu = path_.mean_product();
    path_.aim(0.);
    find_direction();

    // what is missing to first order, and to where the prediction says
    path_.aim_with_correction(path_.centring() * mu);
    find_direction();

    const double part   = std::max(shortest_part, 1. - mu / path_.unit());
    const double length = std::min(1., part * path_.largest_step());
    if (!(length > 0.) || !d_.allFinite())
      return false;
    path_.advance(length);
    gradient_ += length * Qd_;
    return true;
  }

  void InteriorPoint::Path::factorize()
  {
    const Eigen::Index m = Q_.rows() / 3;
    Eigen::MatrixXd A    = Q_;
    for (const Eigen::Index i : path_.bounded())
      {
        const std::array<Eigen::Index, 3> k = {i, i + m, i + 2 * m};
        const Matrix3d D                    = path_.compliance(i);
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c)
            A(k[r], k[c]) += D(r, c);
        if (!path_.has_friction(i))
          for (const Eigen::Index t : {k[1], k[2]})
            {
              A.row(t).setZero();
              A.col(t).setZero();
              A(t, t) = Q_(t, t);
            }
      }
    unit_ = A.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    lu_.compute(unit_.asDiagonal() * A * unit_.asDiagonal());
  }

  void InteriorPoint::Path::find_direction()
  {
    // without bounds the step is Newton's
    const VectorXd missing   = gradient_ - path_.w();
    VectorXd right_hand_side = path_.right_hand_side() - missing;
    for (const Eigen::Index i : path_.bounded())
      if (!path_.has_friction(i))
        set_at_node(right_hand_side, i, {right_hand_side(i), 0., 0.});
    d_            = unit_.cwiseProduct(lu_.solve(unit_.cwiseProduct(right_hand_side)));
    Qd_.noalias() = Q_ * d_;
    path_.set_direction(d_, missing + Qd_);
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
