#ifndef stiction_contact_obstacles_obstacle_motion_h
#define stiction_contact_obstacles_obstacle_motion_h

#include <Eigen/Core>

namespace stiction
{
  /// How displacements U of the obstacles look from the contact nodes, in
  /// contact variables: the offset e = (d + n·U; s1 t1·U; s2 t2·U) in
  /// r = e − Bu = (remaining gap; −slip).
  ///
  /// Some obstacles are free to move along a direction a, with a force P that
  /// presses them on: e = e0 + C δ, a column C_j = M a of C for each of them.
  /// Its distance δ_j is an unknown, and the force that it exerts on the body
  /// along a is −C_jᵀλ, which has to be P_j.
  class ObstacleMotion
  {
  public:
    ObstacleMotion() = default;

    /// @param offset e0, length 3m.
    /// @param directions C, 3m × n.
    ObstacleMotion(Eigen::VectorXd offset, Eigen::MatrixXd directions);

    /// e, length 3m. Unit: m.
    const Eigen::VectorXd &offset() const { return offset_; }

    /// e0, of obstacles that were not moved by a force.
    Eigen::VectorXd offset_at_start() const { return offset_ - directions_ * distances_; }

    /// C, 3m × n.
    const Eigen::MatrixXd &directions() const { return directions_; }

    /// δ, length n. Unit: m.
    const Eigen::VectorXd &distances() const { return distances_; }

    /// Moves the free obstacles to these distances. @return the change of e.
    Eigen::VectorXd move_to(const Eigen::VectorXd &distances);

  private:
    Eigen::VectorXd offset_;
    Eigen::MatrixXd directions_;
    Eigen::VectorXd distances_;
  };
} // namespace stiction

#endif
