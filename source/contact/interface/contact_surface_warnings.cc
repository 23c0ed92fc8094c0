// What the forces of a pair tell of how far its answer is to be trusted.

#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/pairs/climbed_facets.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stiction
{
  using dealii::Point;

  namespace
  {
    // A node with less is beyond the edge of what lies opposite, but for rounding.
    constexpr double covered = 0.499;
  } // namespace

  ContactSurface::BeyondEdge ContactSurface::beyond_edge(
    const ContactBoundary &pair, const Eigen::VectorXd &lambda) const
  {
    struct
    {
      double force = 0., pressure = 0.;
    } beyond, opposite;
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      if (boundaries_[nodes_[i].boundary].id() == pair.id())
        {
          auto &there        = nodes_[i].cover < covered ? beyond : opposite;
          const double force = std::max(lambda(i), 0.);
          there.force += force;
          there.pressure = std::max(there.pressure, force / areas_(i));
        }
    BeyondEdge result;
    if (beyond.force > 0.)
      result.share = beyond.force / (beyond.force + opposite.force);
    if (opposite.pressure > 0.)
      result.peak = std::max(1., beyond.pressure / opposite.pressure);
    return result;
  }

  ContactSurface::AcrossGap ContactSurface::across_gap(
    const ContactBoundary &pair, const Eigen::VectorXd &lambda) const
  {
    double pressing = 0., friction = 0., across = 0., moment = 0.;
    Point<3> centre;
    const auto of_pair = [&](const auto &look_at) {
      for (Eigen::Index i = 0; i < n_nodes(); ++i)
        if (boundaries_[nodes_[i].boundary].id() == pair.id() && lambda(i) > 0.)
          look_at(nodes_[i], at_node(lambda, i));
    };
    of_pair([&](const ContactNode &node, const Eigen::Vector3d &force) {
      pressing += force(0);
      centre += force(0) * node.position;
    });
    of_pair([&](const ContactNode &node, const Eigen::Vector3d &force) {
      const Mortar &mortar    = *mortars_[node.boundary];
      const double tangential = force.tail<2>().norm();
      friction += tangential;
      across += tangential * std::abs(mortar.gaps(mortar.row_of(node.first_dof)));
      moment += force.norm() * node.position.distance(centre / pressing);
    });
    return moment > 0. && friction > 0. ? AcrossGap{across / friction, across / moment}
                                        : AcrossGap{};
  }

  double ContactSurface::climbed_facets(const ContactBoundary &pair,
                                        const State &state) const
  {
    const Eigen::VectorXd moved = relative_displacement(state);
    std::vector<Eigen::Index> pressed;
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      if (boundaries_[nodes_[i].boundary].id() == pair.id() && state.lambda(i) > 0.)
        pressed.push_back(i);
    const auto n = static_cast<Eigen::Index>(pressed.size());
    Eigen::MatrixX3d positions(n, 3), normals(n, 3), slip(n, 3);
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const ContactNode &node = nodes_[pressed[k]];
        for (unsigned int c = 0; c < 3; ++c)
          {
            positions(k, c) = node.position[c];
            normals(k, c)   = node.normal[c];
          }
        slip.row(k) = -at_node(moved, pressed[k]).transpose();
      }
    return n == 0 ? 0.
                  : stiction::climbed_facets(positions, normals, slip, areas_(pressed),
                                             state.lambda(pressed));
  }

  ContactSurface::Slide ContactSurface::slide(const ContactBoundary &pair,
                                              const State &state) const
  {
    const Eigen::VectorXd moved = relative_displacement(state);
    double way = 0., area = 0., n = 0.;
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      if (const ContactNode &node = nodes_[i];
          boundaries_[node.boundary].id() == pair.id() && state.lambda(i) > 0.)
        {
          way = std::max(way, (node.axes() * at_node(moved, i)).tail<2>().norm());
          area += areas_(i);
          n += 1.;
        }
    return {way, n > 0. ? std::sqrt(area / n) : 1.};
  }

} // namespace stiction
