#include <stiction/contact/obstacles/obstacle_motion.h>

#include <cmath>
#include <utility>

namespace stiction
{
  ObstacleMotion::ObstacleMotion(Eigen::VectorXd offset, Eigen::MatrixXd directions,
                                 Eigen::VectorXd forces)
    : offset_(std::move(offset))
    , directions_(std::move(directions))
    , forces_(std::move(forces))
  {
  }

  Eigen::VectorXd ObstacleMotion::offset(const Eigen::VectorXd &distances) const
  {
    return n_pressed() == 0 ? offset_
                            : Eigen::VectorXd(offset_ + displacement(distances));
  }

  Eigen::VectorXd ObstacleMotion::missing_forces(const Eigen::VectorXd &lambda) const
  {
    return forces_ + forces_along(lambda);
  }

  double ObstacleMotion::relative_error(const Eigen::VectorXd &errors) const
  {
    double largest = 0.;
    for (Eigen::Index j = 0; j < n_pressed(); ++j)
      if (forces_(j) > 0. && !(std::abs(errors(j)) <= largest * forces_(j)))
        largest = std::abs(errors(j)) / forces_(j); // a NaN, too
    return largest;
  }
} // namespace stiction
