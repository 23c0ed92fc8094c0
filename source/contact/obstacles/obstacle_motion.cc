#include <stiction/contact/obstacles/obstacle_motion.h>

#include <utility>

namespace stiction
{
  ObstacleMotion::ObstacleMotion(Eigen::VectorXd offset, Eigen::MatrixXd directions)
    : offset_(std::move(offset))
    , directions_(std::move(directions))
    , distances_(Eigen::VectorXd::Zero(directions_.cols()))
  {
  }

  Eigen::VectorXd ObstacleMotion::move_to(const Eigen::VectorXd &distances)
  {
    const Eigen::VectorXd change = directions_ * (distances - distances_);
    offset_ += change;
    distances_ = distances;
    return change;
  }
} // namespace stiction
