#include <stiction/contact/certificate/pair_figures.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/pairs/climbed_facets.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stiction
{
  namespace
  {
    // A node with less is beyond the edge of what lies opposite, but for rounding.
    constexpr double covered = 0.499;

    // The nodes of a pair that are pressed, by rows.
    struct PressedNodes
    {
      std::vector<const ContactNode *> nodes;
      Eigen::MatrixX3d positions, normals, forces, slip; // forces by (ν; t1; t2)
      Eigen::VectorXd areas;

      PressedNodes(const ContactSurface &surface, const ContactBoundary &pair,
                   const State &state)
      {
        std::vector<Eigen::Index> pressed;
        for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
          if (const ContactNode &node = surface.nodes()[i];
              surface.boundaries()[node.boundary].id() == pair.id() &&
              state.lambda(i) > 0.)
            {
              pressed.push_back(i);
              nodes.push_back(&node);
            }
        const auto n = static_cast<Eigen::Index>(pressed.size());
        for (Eigen::MatrixX3d *const rows : {&positions, &normals, &forces, &slip})
          rows->resize(n, 3);
        areas                       = surface.areas()(pressed);
        const Eigen::VectorXd moved = surface.relative_displacement(state);
        for (Eigen::Index k = 0; k < n; ++k)
          {
            for (unsigned int c = 0; c < 3; ++c)
              {
                positions(k, c) = nodes[k]->position[c];
                normals(k, c)   = nodes[k]->normal[c];
              }
            forces.row(k) = at_node(state.lambda, pressed[k]);
            slip.row(k)   = -at_node(moved, pressed[k]);
          }
      }
    };

    void add_edge(const PressedNodes &pressed, PairFigures &figures)
    {
      struct
      {
        double force = 0., pressure = 0.;
      } beyond, opposite;
      for (std::size_t k = 0; k < pressed.nodes.size(); ++k)
        {
          auto &there        = pressed.nodes[k]->cover < covered ? beyond : opposite;
          const double force = pressed.forces(k, 0);
          there.force += force;
          there.pressure = std::max(there.pressure, force / pressed.areas(k));
        }
      figures.share_beyond_edge = beyond.force / (beyond.force + opposite.force);
      if (opposite.pressure > 0.)
        figures.peak_beyond_edge = std::max(1., beyond.pressure / opposite.pressure);
    }

    void add_gap(const PressedNodes &pressed, PairFigures &figures)
    {
      const auto row = [](const Eigen::MatrixX3d &rows, const std::size_t k) {
        return Eigen::Vector3d(rows.row(static_cast<Eigen::Index>(k)));
      };
      // λ by (x; y; z)
      const auto force_at = [&](const std::size_t k) -> Eigen::Vector3d {
        return pressed.nodes[k]->axes().transpose() * row(pressed.forces, k);
      };
      Eigen::Vector3d across = Eigen::Vector3d::Zero(), centre = Eigen::Vector3d::Zero();
      double friction = 0., gap = 0.;
      for (std::size_t k = 0; k < pressed.nodes.size(); ++k)
        {
          const ContactNode &node = *pressed.nodes[k];
          const double tangential = row(pressed.forces, k).tail<2>().norm();
          across += node.mesh_gap * row(pressed.normals, k).cross(force_at(k));
          centre += pressed.forces(k, 0) / pressed.forces.col(0).sum() *
                    row(pressed.positions, k);
          friction += tangential;
          gap += tangential * std::abs(node.mesh_gap);
        }
      if (across.norm() == 0.)
        return;
      double moment = 0.;
      for (std::size_t k = 0; k < pressed.nodes.size(); ++k)
        moment += std::abs((row(pressed.positions, k) - centre)
                             .cross(force_at(k))
                             .dot(across.normalized()));
      figures.gap               = gap / friction;
      figures.moment_across_gap = across.norm() / moment;
    }

    void add_way(const PressedNodes &pressed, PairFigures &figures)
    {
      for (std::size_t k = 0; k < pressed.nodes.size(); ++k)
        figures.way = std::max(
          figures.way,
          (pressed.nodes[k]->axes() * pressed.slip.row(k).transpose()).tail<2>().norm());
      figures.spacing =
        std::sqrt(pressed.areas.sum() / static_cast<double>(pressed.nodes.size()));
    }
  } // namespace

  PairFigures pair_figures(const ContactSurface &surface, const ContactBoundary &pair,
                           const State &state)
  {
    PairFigures figures;
    const PressedNodes pressed(surface, pair, state);
    if (pressed.nodes.empty())
      return figures;
    add_edge(pressed, figures);
    add_gap(pressed, figures);
    add_way(pressed, figures);
    figures.climbed = climbed_facets(pressed.positions, pressed.normals, pressed.slip,
                                     pressed.areas, pressed.forces.col(0));
    return figures;
  }
} // namespace stiction
