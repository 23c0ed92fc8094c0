#ifndef stiction_qp_anderson_h
#define stiction_qp_anderson_h

#include <Eigen/Core>

#include <deque>

namespace stiction::qp
{
  /// Anderson's extrapolation (1965) for a fixed point g = Φ(g): the next g
  /// from the last few pairs (g, Φ(g)), so that the differences Φ(g) − g,
  /// combined with the same weights, are smallest.
  class Anderson
  {
  public:
    /// The next point after g was found to map to image = Φ(g). Without a
    /// history this is the image itself.
    Eigen::VectorXd
    next(const Eigen::VectorXd &g, const Eigen::VectorXd &image);

    /// Forgets the history.
    void
    restart();

  private:
    std::deque<Eigen::VectorXd> images_, residuals_;
  };
} // namespace stiction::qp

#endif
