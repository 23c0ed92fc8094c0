#pragma once

#include <Eigen/Core>

namespace stiction
{
  /// How displacements U of the obstacles look from the contact nodes, in
  /// contact variables: the offset e = (d + n·U; s1 t1·U; s2 t2·U) in
  /// r = e − Bu = (remaining gap; −slip). Where an obstacle turns, its surface moves
  /// along itself: U has a part that counts along t1 and t2 alone.
  ///
  /// Some obstacles are free to move along a direction a, with a force P that
  /// presses them on: e = e0 + C δ, a column C_j = M a of C for each of them.
  /// Its distance δ_j is an unknown, the multiplier of the equality constraint
  /// −C_jᵀλ = P_j: the force that it exerts on the body along a is P_j.
  class ObstacleMotion
  {
  public:
    ObstacleMotion() = default;

    /// @param offset e0, length 3m, m.
    /// @param directions C, 3m × n.
    /// @param forces P, length n, N, > 0; 0 for an obstacle that no node can meet.
    ObstacleMotion(Eigen::VectorXd offset, Eigen::MatrixXd directions,
                   Eigen::VectorXd forces);

    /// n.
    Eigen::Index n_pressed() const { return forces_.size(); }

    /// e with the free obstacles at these distances δ, length 3m. Unit: m.
    Eigen::VectorXd offset(const Eigen::VectorXd &distances) const;

    /// e0, as the nodes of a pressed obstacle see it at δ = 0.
    const Eigen::VectorXd &offset_at_start() const { return offset_; }

    /// C, 3m × n.
    const Eigen::MatrixXd &directions() const { return directions_; }

    /// C δ, length 3m: how contact nodes see the obstacles move. Unit: m.
    Eigen::VectorXd displacement(const Eigen::VectorXd &distances) const
    {
      return directions_.lazyProduct(distances); // BLAS refuses a level without nodes
    }

    /// Cᵀ λ, length n: the contact forces along the ways of the obstacles. Unit: N.
    Eigen::VectorXd forces_along(const Eigen::VectorXd &lambda) const
    {
      return directions_.transpose().lazyProduct(lambda);
    }

    /// P, length n. Unit: N.
    const Eigen::VectorXd &forces() const { return forces_; }

    /// P + Cᵀλ: by what the contact forces fall short of the prescribed ones.
    /// Unit: N.
    Eigen::VectorXd missing_forces(const Eigen::VectorXd &lambda) const;

    /// max_j |error_j|/P_j for errors of the forces; 0 if no obstacle is pressed.
    double relative_error(const Eigen::VectorXd &errors) const;

    /// That of missing_forces().
    double force_error(const Eigen::VectorXd &lambda) const
    {
      return relative_error(missing_forces(lambda));
    }

  private:
    Eigen::VectorXd offset_;
    Eigen::MatrixXd directions_;
    Eigen::VectorXd forces_;
  };
} // namespace stiction
