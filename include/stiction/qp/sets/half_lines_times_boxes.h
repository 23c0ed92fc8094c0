#pragma once

#include <stiction/qp/sets/feasible_set.h>

namespace stiction::qp
{
  /// x_i ≥ 0 in the first block and |x_i| ≤ b_i in each of the others: bounds
  /// only, as for the rotated squares that replace the circles. Half-widths
  /// may be zero, and infinite where a node is tied.
  class HalfLinesTimesBoxes : public FeasibleSet
  {
  public:
    /// n_intervals ≥ 0 blocks of intervals, all with the same half-widths.
    /// Throws std::invalid_argument if one is negative or not a number.
    HalfLinesTimesBoxes(Eigen::VectorXd half_widths, unsigned int n_intervals);

    void project(Eigen::VectorXd &x) const override;

    /// Bounds are met entry by entry: a node may have free and chopped entries
    /// at once.
    void split(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient, double step,
               Eigen::VectorXd &free, Eigen::VectorXd &chopped) const override;

    double largest_feasible_step(const Eigen::VectorXd &x,
                                 const Eigen::VectorXd &d) const override;

  private:
    Eigen::VectorXd half_widths_;
    HalfLines half_lines_;
  };
} // namespace stiction::qp
