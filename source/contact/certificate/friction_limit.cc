#include <stiction/contact/certificate/friction_limit.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/free_motions.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <cmath>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the way of pressed nodes what a body that slides goes as a whole, at least, and
    // of that what goes along the normal at any of them, at most.
    constexpr double as_a_whole = 0.9, into_normal = 0.1;

    // Of the largest force: a node with less holds nothing.
    constexpr double no_force = 1e-6;

    // Of one body, over its pressed nodes, weighted with their forces.
    struct Ways
    {
      bool slips = false, is_held = false;
      double all = 0., as_a_whole = 0.;
    };

    // The bodies of a boundary, those opposite, both; and whether they are one on either
    // side and no obstacle moves.
    struct Sides
    {
      std::set<unsigned int> own, opposite, all;
      bool are_known;
    };

    std::vector<Sides> sides_of(const Body &body, const ContactSurface &surface,
                                const State &state)
    {
      std::vector<Sides> sides;
      for (const ContactBoundary &boundary : surface.boundaries())
        {
          const auto own = body.pieces_at(boundary.id());
          std::set<unsigned int> opposite;
          for (const auto partner : boundary.partners())
            opposite.merge(body.pieces_at(partner));
          sides.push_back(
            {own, opposite, boundary.pieces(body),
             own.size() == 1 && opposite.size() <= 1 && boundary.angle() == 0. &&
               surface.obstacle_displacement(boundary.id(), state.distances).norm() ==
                 0.});
        }
      return sides;
    }

    // How far the body of a node moves as a whole, against the one opposite.
    Tensor<1, 3> way_as_a_whole(const Sides &sides,
                                const std::vector<RigidMotion> &motions,
                                const Point<3> &x)
    {
      Tensor<1, 3> way = motions[*sides.own.begin()].at(x);
      for (const unsigned int other : sides.opposite)
        way -= motions[other].at(x);
      return way;
    }
  } // namespace

  std::set<unsigned int> bodies_at_friction_limit(const LinearElasticity &elasticity,
                                                  const ContactSurface &surface,
                                                  const std::vector<RigidMotion> &motions,
                                                  const State &state,
                                                  const std::vector<NodeStatus> &statuses)
  {
    const auto sides    = sides_of(elasticity.body(), surface, state);
    const auto relative = surface.relative_displacement(state);
    const double least  = no_force * state.lambda.head(surface.n_nodes()).maxCoeff();
    std::vector<Ways> ways(motions.size());
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        const Sides &of_node    = sides[node.boundary];
        const double force      = state.lambda(i);
        if (force <= least)
          continue;
        Tensor<1, 3> rigid, way = to_tensor(at_node(relative, i));
        if (of_node.are_known)
          rigid = way_as_a_whole(of_node, motions, node.position);
        const auto friction = statuses[i].tangential;
        const bool is_held  = !of_node.are_known || friction == TangentialStatus::stick ||
                             friction == TangentialStatus::tied ||
                             std::abs(rigid * node.normal) > into_normal * rigid.norm();
        way -= (way * node.normal) * node.normal;
        for (const unsigned int piece : of_node.all)
          {
            Ways &of   = ways[piece];
            of.slips   = of.slips || friction == TangentialStatus::slip;
            of.is_held = of.is_held || is_held;
            of.all += force * way.norm();
            of.as_a_whole += force * rigid.norm();
          }
      }
    std::set<unsigned int> at_limit;
    for (unsigned int piece = 0; piece < ways.size(); ++piece)
      if (const Ways &of = ways[piece]; elasticity.free_motions().of(piece).second > 0 &&
                                        of.slips && !of.is_held &&
                                        of.as_a_whole > as_a_whole * of.all)
        at_limit.insert(piece);
    return at_limit;
  }
} // namespace stiction
