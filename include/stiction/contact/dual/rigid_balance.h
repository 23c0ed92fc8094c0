#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/qp/operators/equality_constraint.h>

#include <Eigen/Core>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;

  /// What contact forces have to balance, whatever the body does: first the forces that
  /// press obstacles on, then the loads along the free motions Z of the body, with the
  /// columns −BZ of G. Collective.
  EqualityConstraint rigid_balance(const LinearElasticity &elasticity,
                                   const ContactSurface &surface);

  /// The free motions of the body that qp::resisted_and_others() names, none where
  /// friction depends on the answer. Collective.
  Eigen::MatrixXd unresisted_motions(const LinearElasticity &elasticity,
                                     const ContactSurface &surface);

  /// Takes the part of the free motions that nothing resists with the forces of a state,
  /// where pressures are gone not even friction, off its u as far as this has it beyond
  /// another displacement, on the mean of the nodes. Bodies are kept where they were
  /// along what they may lie on, not across it. Collective.
  ///
  /// @param tolerance less than this part of the forces of earlier steps presses nothing.
  void leave_in_place(const LinearElasticity &elasticity, const ContactSurface &surface,
                      const LA::Vector &before, double tolerance, State &state);
} // namespace stiction
