#include <stiction/qp/sets/half_lines_times_boxes.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace stiction::qp
{
  namespace
  {
    // A step to a bound ends there only up to rounding. Nearer to it than this
    // part of the half-width counts as on it.
    constexpr double on_bound = 1. - 1e-12;
  } // namespace

  HalfLinesTimesBoxes::HalfLinesTimesBoxes(Eigen::VectorXd half_widths,
                                           const unsigned int n_intervals)
    : FeasibleSet(half_widths.size(), 1 + n_intervals)
    , half_widths_(std::move(half_widths))
    , half_lines_(half_widths_)
  {
    for (const double half_width : half_widths_)
      if (!(half_width >= 0.))
        throw std::invalid_argument("the half-width of a box must be >= 0");
  }

  void HalfLinesTimesBoxes::project(Eigen::VectorXd &x) const
  {
    eigen_assert(x.size() == size());
    const Eigen::Index m = n_nodes();
    Eigen::VectorXd xn   = x.head(m);
    half_lines_.project(xn);
    x.head(m) = xn;
    for (Eigen::Index k = m; k < size(); ++k)
      {
        const double b = half_widths_(k % m);
        if (std::abs(x(k)) > b) // a NaN stays one
          x(k) = std::copysign(b, x(k));
      }
  }

  void HalfLinesTimesBoxes::split(const Eigen::VectorXd &x,
                                  const Eigen::VectorXd &gradient, const double step,
                                  Eigen::VectorXd &free, Eigen::VectorXd &chopped) const
  {
    eigen_assert(x.size() == size() && gradient.size() == size());
    const Eigen::Index m = n_nodes();
    Eigen::VectorXd free_n, chopped_n;
    half_lines_.split(x.head(m), gradient.head(m), step, free_n, chopped_n);

    free.setZero(size());
    chopped.setZero(size());
    free.head(m)    = free_n;
    chopped.head(m) = chopped_n;
    for (Eigen::Index k = m; k < size(); ++k)
      {
        const double b = half_widths_(k % m);
        // What points inwards, no further than to the opposite bound; nowhere
        // in an interval that is a point.
        if (!(std::abs(x(k)) >= on_bound * b))
          free(k) = gradient(k);
        else if (x(k) > 0.)
          chopped(k) = std::min(std::max(gradient(k), 0.), 2. * b / step);
        else
          chopped(k) = std::max(std::min(gradient(k), 0.), -2. * b / step);
      }
  }

  double HalfLinesTimesBoxes::largest_feasible_step(const Eigen::VectorXd &x,
                                                    const Eigen::VectorXd &d) const
  {
    const Eigen::Index m = n_nodes();
    double alpha         = half_lines_.largest_feasible_step(x.head(m), d.head(m));
    for (Eigen::Index k = m; k < size(); ++k)
      if (d(k) != 0.)
        {
          const double room =
            d(k) > 0. ? half_widths_(k % m) - x(k) : half_widths_(k % m) + x(k);
          alpha = std::min(alpha, std::max(room, 0.) / std::abs(d(k)));
        }
    return alpha;
  }
} // namespace stiction::qp
