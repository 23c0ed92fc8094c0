#include <stiction/contact/certificate/friction_limit.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/contact/interface/friction_parameters.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/free_motions.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the way of pressed nodes what a body that slides goes as a whole, at least, and
    // of that what goes along the normal at any of them, at most.
    constexpr double as_a_whole = 0.9, into_normal = 0.1;

    // What friction bears and what of it acts against the way of such a body differ by
    // α²/2 of it for the angle α between them, and the way is what is elastic over α. Of
    // pressures, in tolerances: within that α is not known. And of friction, at most.
    constexpr double unknown = 2., against_way = 0.995;

    // Of the largest force: a node with less holds nothing.
    constexpr double no_force = 1e-6;

    // Of the largest displacement: less is no slip worth a word.
    constexpr double least_slip = 1e-3;

    // Of the largest slip of a pair: beside a plane of symmetry a mean of what lies
    // opposite slips by less.
    constexpr double part_of_pair = 0.3;

    // Of the largest force of earlier steps: less friction is what a tolerance left.
    constexpr double least_friction = 1e-6;

    // Of one body, over its pressed nodes, weighted with their forces.
    struct Ways
    {
      bool slips = false, is_held = false;
      double all = 0., as_a_whole = 0.;
      // their bounds, friction along the way, and pressures, times the way
      double friction = 0., against = 0., pressed = 0.;
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
                                                  const std::vector<NodeStatus> &statuses,
                                                  const double tolerance)
  {
    const FreeMotions &free       = elasticity.free_motions();
    const Eigen::VectorXd amounts = elasticity.free_motion_of(state.u);
    Eigen::VectorXd power         = Eigen::VectorXd::Zero(free.n()); // of the pressures
    const auto sides              = sides_of(elasticity.body(), surface, state);
    const auto relative           = surface.relative_displacement(state);
    const auto forces             = surface.forces(state.lambda);
    const Eigen::VectorXd bound   = surface.slip_bound().at(state.lambda);
    const double least = no_force * state.lambda.head(surface.n_nodes()).maxCoeff();
    std::vector<Ways> ways(motions.size());
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        const Sides &of_node    = sides[node.boundary];
        const double force      = state.lambda(i);
        if (force <= least)
          continue;
        Tensor<1, 3> rigid, way = to_tensor(at_node(relative, i)) + node.turning;
        if (of_node.are_known)
          rigid = way_as_a_whole(of_node, motions, node.position);
        const auto friction = statuses[i].tangential;
        const bool is_held  = !of_node.are_known || friction == TangentialStatus::stick ||
                             friction == TangentialStatus::tied ||
                             std::abs(rigid * node.normal) > into_normal * rigid.norm();
        way -= (way * node.normal) * node.normal;
        const Tensor<1, 3> along = rigid - (rigid * node.normal) * node.normal;
        for (const unsigned int piece : of_node.all)
          {
            power += (of_node.own.count(piece) > 0 ? force : -force) *
                     free.at(node.position, piece).transpose() *
                     Eigen::Vector3d(node.normal[0], node.normal[1], node.normal[2]);
            Ways &of   = ways[piece];
            of.slips   = of.slips || friction == TangentialStatus::slip;
            of.is_held = of.is_held || is_held;
            of.all += force * way.norm();
            of.as_a_whole += force * rigid.norm();
            of.friction += bound(i) * along.norm();
            of.pressed += force * along.norm();
            of.against += to_tensor(at_node(forces, i)) * along;
          }
      }
    // where pressures work along a motion, as on a wedge, it ends where they balance
    // loads
    const auto is_free = [&](const unsigned int piece) {
      const auto [begin, n]         = free.of(piece);
      const Eigen::VectorXd all     = amounts.segment(begin, n);
      const Eigen::VectorXd pressed = power.segment(begin, n).stableNormalized();
      return (all - all.dot(pressed) * pressed).norm() > as_a_whole * all.norm();
    };
    std::set<unsigned int> at_limit;
    for (unsigned int piece = 0; piece < ways.size(); ++piece)
      if (const Ways &of = ways[piece];
          free.of(piece).second > 0 && of.slips && !of.is_held &&
          of.as_a_whole > as_a_whole * of.all &&
          std::abs(of.against) >= std::max(of.friction - unknown * tolerance * of.pressed,
                                           against_way * of.friction) &&
          is_free(piece))
        at_limit.insert(piece);
    return at_limit;
  }

  std::vector<double> frictionless_parts(const ContactSurface &surface,
                                         const State &state)
  {
    const auto &boundaries = surface.boundaries();
    // who has come back lacks friction as well
    const Eigen::VectorXd of_all_steps = surface.relative_displacement(state),
                          of_this_step = surface.slip_since_origin(state),
                          bound        = surface.slip_bound().at(state.lambda);
    std::vector<double> parts(boundaries.size(), 0.), all = parts;
    std::vector<std::array<double, 3>> least(boundaries.size());
    for (auto &of_components : least)
      of_components.fill(least_slip * state.u.linfty_norm());
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      if (const ContactNode &node = surface.nodes()[i];
          boundaries[node.boundary].is_pair())
        {
          const Tensor<1, 3> slip       = to_tensor(at_node(of_all_steps, i));
          const Tensor<1, 3> tangential = slip - (slip * node.normal) * node.normal;
          for (unsigned int c = 0; c < 3; ++c)
            least[node.boundary][c] =
              std::max(least[node.boundary][c], part_of_pair * std::abs(tangential[c]));
        }
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        const double force      = std::max(state.lambda(i), 0.);
        if (surface.slip_bound().is_tied(i))
          continue;
        all[node.boundary] += force;
        bool lacks = false; // dragged nodes have scales
        for (unsigned int c = 0; c < 3; ++c)
          lacks = lacks || (node.prescribed[c] && node.scale[0] == 0. &&
                            std::max(std::abs(at_node(of_all_steps, i)(c)),
                                     std::abs(at_node(of_this_step, i)(c))) >
                              least[node.boundary][c]);
        if (bound(i) > 0. && lacks)
          parts[node.boundary] += force;
      }
    for (std::size_t b = 0; b < parts.size(); ++b)
      parts[b] = all[b] > 0. ? parts[b] / all[b] : 0.;
    return parts;
  }

  std::vector<double> falls_of_friction(const ContactSurface &surface, const State &state)
  {
    const auto &boundaries      = surface.boundaries();
    const Eigen::VectorXd r     = surface.gap_and_slip(state);
    const Eigen::VectorXd &path = state.history.path;
    std::vector<double> falls(boundaries.size(), 0.), all = falls;
    for (Eigen::Index i = 0; i < path.size(); ++i)
      {
        const ContactNode &node      = surface.nodes()[i];
        const FrictionData &friction = boundaries[node.boundary].friction();
        if (state.lambda(i) <= 0. || !friction.depends_on_rubbing())
          continue;
        const double pressure = state.lambda(i) / node.area;
        const double slip     = node
                              .displacement_to_cartesian({0., r(i + surface.n_nodes()),
                                                          r(i + 2 * surface.n_nodes())})
                              .norm();
        const double before =
                       friction.value(node, {pressure, std::max(path(i) - slip, 0.)}),
                     now = friction.value(node, {pressure, path(i)});
        const double weight =
          friction.law() == FrictionLaw::coulomb ? state.lambda(i) : node.area;
        all[node.boundary] += weight * before;
        falls[node.boundary] += weight * std::max(before - now, 0.);
      }
    for (std::size_t b = 0; b < falls.size(); ++b)
      falls[b] = all[b] > least_friction * state.scales.force ? falls[b] / all[b] : 0.;
    return falls;
  }
} // namespace stiction
