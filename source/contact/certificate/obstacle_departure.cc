#include <stiction/contact/certificate/obstacle_departure.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <cmath>

namespace stiction
{
  using namespace dealii;

  ObstacleDeparture obstacle_departure(const ContactSurface &surface,
                                       const ContactBoundary &boundary,
                                       const State &state)
  {
    ObstacleDeparture departure;
    if (boundary.obstacle() == nullptr)
      return departure;
    double all                  = 0.;
    const Eigen::VectorXd moved = surface.relative_displacement(state);
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        const double force      = state.lambda(i);
        if (force <= 0. || surface.boundary_of(node).id() != boundary.id())
          continue;
        ContactNode there = node;
        there.moved       = -to_tensor(at_node(moved, i));
        boundary.place_if_possible(there);
        const double distance = there.gap - there.normal * there.moved,
                     linear   = node.gap - node.normal * there.moved;
        departure.distance += force * std::abs(distance - linear);
        departure.turn += force * (there.normal - node.normal).norm();
        departure.slip += force * (there.moved - node.moved).norm();
        departure.spacing += force * std::sqrt(node.area);
        all += force;
      }
    if (all == 0.)
      return {};
    return {departure.distance / all, departure.turn / all, departure.slip / all,
            departure.spacing / all};
  }
} // namespace stiction
