#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <cstddef>

namespace stiction
{
  SlipHistory on_nodes(const SlipHistory &history, const ContactSurface &surface)
  {
    if (history.nodes.empty())
      return history;
    const Eigen::Index m = surface.n_nodes();
    SlipHistory here{surface.first_dofs(), Eigen::VectorXd::Zero(3 * m),
                     Eigen::VectorXd::Zero(m), history.angles};
    for (std::size_t k = 0; k < history.nodes.size(); ++k)
      if (const Eigen::Index i = surface.node_of(history.nodes[k]); i >= 0)
        {
          const auto before = static_cast<Eigen::Index>(k);
          set_at_node(here.origin, i, at_node(history.origin, before));
          here.path(i) = history.path(before);
        }
    return here;
  }

  Eigen::VectorXd on_frames(const Eigen::VectorXd &lambda, const ContactSurface &before,
                            const ContactSurface &now)
  {
    const Eigen::VectorXd forces = before.forces(lambda);
    Eigen::VectorXd there        = Eigen::VectorXd::Zero(3 * now.n_nodes());
    for (Eigen::Index k = 0; k < before.n_nodes(); ++k)
      if (const Eigen::Index i = now.node_of(before.nodes()[k].first_dof); i >= 0)
        set_at_node(there, i, now.nodes()[i].force_to_local(at_node(forces, k)));
    return there;
  }

  Eigen::VectorXd slip_path(const State &state, const ContactSurface &surface)
  {
    const Eigen::Index m = surface.n_nodes();
    Eigen::VectorXd path =
      state.history.path.size() > 0 ? state.history.path : Eigen::VectorXd::Zero(m);
    if (state.lambda.size() == 0)
      return path;
    const Eigen::VectorXd r = surface.gap_and_slip(state);
    for (Eigen::Index i = 0; i < m; ++i)
      if (state.lambda(i) > 0.)
        {
          Eigen::Vector3d slip = at_node(r, i);
          slip(0)              = 0.;
          path(i) += surface.nodes()[i].displacement_to_cartesian(slip).norm();
        }
    return path;
  }

  SlipHistory history_after(const State &state, const ContactSurface &surface)
  {
    return {surface.first_dofs(), surface.slip_origin(state), slip_path(state, surface),
            surface.angles()};
  }
} // namespace stiction
