#include <stiction/qp/solvers/componentwise_secant.h>

#include <algorithm>

namespace stiction::qp
{
  namespace
  {
    // Of the step S(s) − s. Components do depend on each other a little.
    constexpr double shortest = 0.02, longest = 3.;
  } // namespace

  Eigen::VectorXd ComponentwiseSecant::next(const Eigen::VectorXd &s,
                                            const Eigen::VectorXd &S_of_s)
  {
    const Eigen::VectorXd step = S_of_s - s;
    Eigen::VectorXd next       = S_of_s;
    for (Eigen::Index i = 0; i < last_s_.size(); ++i)
      {
        const double change = last_step_(i) - step(i), way = s(i) - last_s_(i);
        // a step that grew has no root ahead
        if (change * way > 0.)
          next(i) = s(i) + std::clamp(way / change, shortest, longest) * step(i);
      }
    last_s_    = s;
    last_step_ = step;
    return next;
  }
} // namespace stiction::qp
