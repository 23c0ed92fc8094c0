#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/simulation/checkpoint/carried_state.h>

namespace stiction
{
  CarriedState::CarriedState(const State &state, const LinearElasticity &elasticity,
                             const ContactSurface &surface)
    : u_(state.u)
    , traction_(elasticity.zero_vector())
    , path_(elasticity.zero_vector())
    , distances_(state.distances)
  {
    const DofSubset &dofs = surface.B().dofs();
    dofs.add_extension(surface.B()
                         .force_to_cartesian(state.lambda)
                         .cwiseQuotient(surface.areas().replicate(3, 1)),
                       traction_);
    if (state.history.path.size() > 0)
      dofs.add_extension(state.history.path.replicate(3, 1), path_);
    // hanging nodes are between others on the refined mesh, too
    elasticity.distribute(traction_);
    elasticity.distribute(path_);
  }

  std::vector<LA::Vector *> CarriedState::fields() { return {&u_, &traction_, &path_}; }

  State CarriedState::on(const LinearElasticity &elasticity,
                         const ContactSurface &surface) const
  {
    const DofSubset &dofs = surface.B().dofs();
    State state{elasticity.zero_vector(),
                surface.B().force_to_local(dofs.restriction(traction_).cwiseProduct(
                  surface.areas().replicate(3, 1))),
                distances_,
                {}};
    state.u.copy_locally_owned_data_from(u_);
    state.history.path   = dofs.restriction(path_).head(surface.n_nodes());
    state.history.nodes  = surface.first_dofs();
    state.history.origin = surface.slip_origin(state);
    state.history.angles = surface.angles();
    return state;
  }
} // namespace stiction
