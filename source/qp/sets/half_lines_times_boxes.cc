#include <stiction/qp/sets/half_lines_times_boxes.h>

#include <stdexcept>

namespace stiction::qp
{
  HalfLinesTimesBoxes::HalfLinesTimesBoxes(const Eigen::VectorXd &half_widths,
                                           const unsigned int n_intervals)
    : Intervals(half_widths, n_intervals)
  {
    for (const double half_width : half_widths)
      if (!(half_width >= 0.))
        throw std::invalid_argument("the half-width of a box must be >= 0");
  }
} // namespace stiction::qp
