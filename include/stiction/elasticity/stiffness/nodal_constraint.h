#pragma once

#include <Eigen/Core>

#include <vector>

namespace stiction
{
  /// What holds a node for the time being, in Cartesian components.
  struct NodalConstraint
  {
    /// The orthogonal projection onto the directions in which the node is free.
    Eigen::Matrix3d projection = Eigen::Matrix3d::Identity();
    /// A spring on it, symmetric, ≥ 0, acting in free directions only. Unit:
    /// N/m.
    Eigen::Matrix3d spring = Eigen::Matrix3d::Zero();
  };

  using NodalSupports = std::vector<NodalConstraint>;
} // namespace stiction
