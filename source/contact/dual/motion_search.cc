#include <stiction/contact/dual/motion_search.h>

namespace stiction
{
  namespace
  {
    // A step is shortened if the error falls by less.
    constexpr double required_fall = 0.9;

    // By this factor, so often.
    constexpr double shortening     = 0.25;
    constexpr double shortest_share = 0.1;

    // Of a step of the method of multipliers: Newton's that are longer lead astray.
    constexpr double farthest = 1e6;
  } // namespace

  Eigen::VectorXd MotionSearch::next(const Eigen::VectorXd &tried,
                                     const Eigen::VectorXd &made, const double error,
                                     const std::function<Eigen::VectorXd()> &newton_step)
  {
    if (share_ > 0. && !(error <= required_fall * error_))
      share_ = shortening * share_ >= shortest_share ? shortening * share_ : 0.;
    else
      {
        from_  = tried;
        made_  = made;
        error_ = error;
        step_  = newton_step();
        share_ = step_.norm() <= farthest * (made - tried).norm() ? 1. : 0.;
      }
    return share_ > 0. ? Eigen::VectorXd(from_ + share_ * step_) : made_;
  }
} // namespace stiction
