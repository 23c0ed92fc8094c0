#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/slip_history.h>
#include <stiction/contact/interface/state.h>
#include <stiction/qp/operators/nodal_blocks.h>

namespace stiction
{
  SlipHistory history_after(const State &state, const ContactSurface &surface)
  {
    const Eigen::Index m = surface.n_nodes();
    SlipHistory history{surface.relative_displacement(state), state.history.path};
    if (history.path.size() == 0)
      history.path = Eigen::VectorXd::Zero(m);
    const Eigen::VectorXd r =
      surface.motion().offset(state.distances) - surface.B().apply(state.u);
    for (Eigen::Index i = 0; i < m; ++i)
      if (state.lambda(i) > 0.)
        {
          Eigen::Vector3d slip = at_node(r, i);
          slip(0)              = 0.;
          history.path(i) += surface.nodes()[i].displacement_to_cartesian(slip).norm();
        }
    return history;
  }
} // namespace stiction
