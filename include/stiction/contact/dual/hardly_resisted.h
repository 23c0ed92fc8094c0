#pragma once

#include <Eigen/Core>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;

  /// The free motions along which contact hardly resists, as a ball turns in a cup
  /// without friction: neither are nodes pressed together nor do they rub, but for what
  /// facets do. Collective.
  Eigen::MatrixXd hardly_resisted_motions(const LinearElasticity &elasticity,
                                          const ContactSurface &surface);
} // namespace stiction
