#pragma once

#include <stiction/qp/operators/equality_constraint.h>
#include <stiction/qp/sets/slip_bound.h>

#include <Eigen/Core>

namespace stiction::qp
{
  /// Where a rigid body rests, and on which forces; see rigid_place().
  struct RigidPlace
  {
    Eigen::VectorXd alpha;  ///< m
    Eigen::VectorXd lambda; ///< of the springs, within the slip bound, N
  };

  /// Where rigid obstacles and a rigid body come to rest if every contact node has a
  /// spring: the multipliers α (m) that make the convex energy
  ///
  ///     Σ ½ρ_i (r_ν,i)₋² + Σ ½ρ_i ‖r_t,i‖² + e·α,   r = r0 + Gα,
  ///
  /// least, the second sum over nodes with friction that touch: a place to start from,
  /// where those nodes touch that can balance the loads.
  ///
  /// @param gradient r0 = (remaining gap; −slip), m. @param stiffness ρ, N/m.
  RigidPlace rigid_place(const EqualityConstraint &constraint,
                         const Eigen::VectorXd &gradient,
                         const Eigen::VectorXd &stiffness, const SlipBound &slip_bound);
} // namespace stiction::qp
