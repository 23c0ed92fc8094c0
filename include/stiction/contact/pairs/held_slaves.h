#pragma once

namespace stiction
{
  class LinearElasticity;
  struct Mortar;

  /// How many slaves are held along some axis along which most of what they face is not:
  /// a tie has no hold on that there, and contact no friction, since such a slave has no
  /// unknown left. Collective.
  unsigned int n_held_alone(const LinearElasticity &elasticity, const Mortar &mortar);
} // namespace stiction
