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
  } // namespace

  std::set<unsigned int> bodies_at_friction_limit(const LinearElasticity &elasticity,
                                                  const ContactSurface &surface,
                                                  const State &state,
                                                  const std::vector<NodeStatus> &statuses)
  {
    const Body &body    = elasticity.body();
    const auto &free    = elasticity.free_motions();
    const auto motions  = free.motions(elasticity.free_motion_of(state.u));
    const auto relative = surface.relative_displacement(state);
    const double least  = no_force * state.lambda.head(surface.n_nodes()).maxCoeff();
    std::vector<Ways> ways(body.pieces().size());
    for (std::size_t b = 0; b < surface.boundaries().size(); ++b)
      {
        const ContactBoundary &boundary = surface.boundaries()[b];
        const auto own                  = body.pieces_at(boundary.id());
        std::set<unsigned int> others, all = own;
        for (const auto partner : boundary.partners())
          others.merge(body.pieces_at(partner));
        all.insert(others.begin(), others.end());
        const bool is_known =
          own.size() == 1 && others.size() <= 1 && boundary.angle() == 0. &&
          surface.obstacle_displacement(boundary.id(), state.distances).norm() == 0.;
        for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
          {
            const ContactNode &node = surface.nodes()[i];
            const double force      = state.lambda(i);
            if (node.boundary != b || force <= least)
              continue;
            Tensor<1, 3> rigid, way = to_tensor(at_node(relative, i));
            if (is_known)
              rigid = motions[*own.begin()].at(node.position) -
                      (others.empty() ? Tensor<1, 3>()
                                      : motions[*others.begin()].at(node.position));
            const auto friction = statuses[i].tangential;
            const bool is_held =
              !is_known || friction == TangentialStatus::stick ||
              friction == TangentialStatus::tied ||
              std::abs(rigid * node.normal) > into_normal * rigid.norm();
            way -= (way * node.normal) * node.normal;
            for (const unsigned int piece : all)
              {
                Ways &of   = ways[piece];
                of.slips   = of.slips || friction == TangentialStatus::slip;
                of.is_held = of.is_held || is_held;
                of.all += force * way.norm();
                of.as_a_whole += force * rigid.norm();
              }
          }
      }
    std::set<unsigned int> at_limit;
    for (unsigned int piece = 0; piece < ways.size(); ++piece)
      if (const Ways &of = ways[piece]; free.of(piece).second > 0 && of.slips &&
                                        !of.is_held &&
                                        of.as_a_whole > as_a_whole * of.all)
        at_limit.insert(piece);
    return at_limit;
  }
} // namespace stiction
