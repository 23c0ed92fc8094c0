#pragma once

#include <Eigen/Core>

#include <deque>

namespace stiction::qp
{
  /// The length of a gradient step that the last two points suggest: that of
  /// Barzilai and Borwein, chosen as in ABBmin (Frassoldati, Zanni and
  /// Zanghirati 2008): the long one, or the shortest of the last short ones
  /// where the two differ much.
  ///
  /// Such a step may raise the energy; who takes it has to look.
  class SpectralStep
  {
  public:
    /// The length of the step to be taken at x, whose gradient is given; never
    /// below @p least, and that where nothing is known yet.
    double next(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient, double least);

  private:
    Eigen::VectorXd last_x_, last_gradient_;
    std::deque<double> short_steps_;
  };
} // namespace stiction::qp
