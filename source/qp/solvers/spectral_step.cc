#include <stiction/qp/solvers/spectral_step.h>

#include <algorithm>

namespace stiction::qp
{
  double SpectralStep::next(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                            const double least)
  {
    // a short step this much shorter than the long one is worth taking
    constexpr double much_shorter = 0.5;
    constexpr std::size_t memory  = 3;

    double step = least;
    if (last_x_.size() == x.size())
      {
        const Eigen::VectorXd dx = x - last_x_;
        const Eigen::VectorXd dr = gradient - last_gradient_;
        const double curvature   = dx.dot(dr);
        if (curvature > 0.)
          {
            const double long_step  = dx.squaredNorm() / curvature;
            const double short_step = curvature / dr.squaredNorm();
            short_steps_.push_back(short_step);
            if (short_steps_.size() > memory)
              short_steps_.pop_front();
            step = short_step < much_shorter * long_step
                     ? *std::min_element(short_steps_.begin(), short_steps_.end())
                     : long_step;
          }
      }
    last_x_        = x;
    last_gradient_ = gradient;
    return std::max(step, least);
  }
} // namespace stiction::qp
