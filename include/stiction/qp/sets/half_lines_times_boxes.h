#pragma once

#include <stiction/qp/sets/feasible_set.h>

namespace stiction::qp
{
  /// Half-lines times intervals, as for the rotated squares that replace the circles.
  /// Half-widths may be zero, and infinite where a node is tied.
  class HalfLinesTimesBoxes : public Intervals
  {
  public:
    /// n_intervals ≥ 0 blocks of intervals, all with the same half-widths.
    /// Throws std::invalid_argument if one is negative or not a number.
    HalfLinesTimesBoxes(const Eigen::VectorXd &half_widths, unsigned int n_intervals);
  };
} // namespace stiction::qp
