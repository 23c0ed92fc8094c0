#pragma once

#include <deal.II/dofs/dof_handler.h>

#include <functional>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;

  /// The estimated error η_K², J, of a cell that this rank owns, see estimate_error().
  /// What is returned throws InputError where a formula has no finite value, or an
  /// obstacle no normal; what is given, but for the state, must outlive it. Collective.
  std::function<double(const dealii::DoFHandler<3>::active_cell_iterator &)> cell_error(
    const LinearElasticity &elasticity, const ContactSurface &surface,
    const State &state);
} // namespace stiction
