#pragma once

#include <stiction/base/units.h>

#include <Eigen/Core>

#include <string>

namespace stiction
{
  class ContactConditions;
  class ContactSurface;
  class LinearElasticity;

  /// If one of several bodies is held by no support and touches nothing: a sentence that
  /// says so. Collective.
  std::string why_loose(const LinearElasticity &elasticity,
                        const ContactSurface &surface);

  /// If no contact forces within the slip bound balance the loads: a sentence on the
  /// motion that nothing stops. Empty: there are such forces, or friction depends on
  /// the answer so that nothing can be said. Collective.
  std::string why_no_equilibrium(const LinearElasticity &elasticity,
                                 const ContactSurface &surface, const Units &units);

  /// If contact forces with the friction that pressures reached bear do not balance the
  /// loads, whatever their normal parts are, by far more than these pressures are wrong:
  /// a sentence on the motion that nothing stops. It tells of these pressures, not
  /// whether there is an equilibrium with others. Collective.
  std::string why_it_slides(const LinearElasticity &elasticity,
                            const ContactSurface &surface,
                            const ContactConditions &reached, const Units &units);

  /// If friction at the pressures of an earlier state does not balance the loads, and
  /// along the motion that is left no contact node is approached, so that pressures do
  /// not rise, and the loads do more work than friction takes at these pressures or less:
  /// a sentence on the motion. A taper that is pushed out of its hub moves so.
  /// Collective.
  ///
  /// @param lambda of the earlier state, on the nodes of the surface.
  std::string why_it_comes_out(const LinearElasticity &elasticity,
                               const ContactSurface &surface,
                               const Eigen::VectorXd &lambda, const Units &units);
} // namespace stiction
