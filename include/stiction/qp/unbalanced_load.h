#pragma once

#include <stiction/qp/operators/equality_constraint.h>
#include <stiction/qp/sets/slip_bound.h>

#include <Eigen/Core>

#include <utility>

namespace stiction::qp
{
  /// Pressures with an error bear friction with one: a load lacks friction for certain
  /// only if the part that is left is beyond this times the error.
  constexpr double safe_beside_pressures = 10.;

  /// What is left of loads that contact forces are to balance.
  struct UnbalancedLoad
  {
    /// Zero: λ balances the loads, Gᵀλ = e. Else there is no equilibrium: −ρ is a motion
    /// along which the loads do the work e·ρ, which is more than that of any contact
    /// forces within the slip bound against it, λ·Gρ. About e − Gᵀλ, N.
    Eigen::VectorXd rho;
    Eigen::VectorXd lambda; ///< those that come nearest, N

    /// What is left as a part of e.
    double part = 0.;

    bool is_balanced() const { return rho.isZero(0.); }
  };

  /// The contact forces with λ_ν ≥ 0 and ‖λ_t‖ ≤ g(λ_ν) that balance the load best. They
  /// are sums of few forces on the cones of single nodes, added one by one where they
  /// gain most, with the best amounts each time (see find_amounts()); given friction
  /// enters as one force of all nodes at a time.
  ///
  /// A load that is left by less than 1e-8 of e is balanced.
  UnbalancedLoad unbalanced_load(const EqualityConstraint &constraint,
                                 const SlipBound &slip_bound);

  /// The motions α along which something may resist, and those along which nothing ever
  /// does: at no contact node does Gα change the gap, or slip where there is friction. By
  /// columns, orthonormal all together.
  std::pair<Eigen::MatrixXd, Eigen::MatrixXd> resisted_and_others(
    const Eigen::MatrixXd &G, const SlipBound &slip_bound);
} // namespace stiction::qp
