#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/deformation.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/simulation/warnings/body_warnings.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of Green's strain ε + ½ (∇u)ᵀ∇u linear elasticity leaves out the second part,
    // from here on 5 % of the first, which is as much as materials are known to, or
    // half a percent of strain in a body that turns.
    constexpr double large_deformation = 0.1;

    // Of a coefficient of friction: a body that friction holds from turning.
    constexpr double much_of_coefficient = 0.1;

    // Of the mean distance of contact forces from their centre.
    constexpr double much_of_arm = 0.25;

    // Of a motion that moves a body by about one: with less it does not turn.
    constexpr double rounding_of_axis = 1e-8;

    // Of the size of all bodies.
    constexpr double rounding_of_way = 1e-6;

    // Of the size of a body: less is no way into another one.
    constexpr double rounding_of_box = 1e-9;

    void add_deformation(const Deformation &deformation, Warnings &warnings)
    {
      const auto &[strain, rotation] = deformation;
      if (strain > large_deformation)
        warnings.push_back(
          {"strain", strain,
           format("strains of up to %.2g: linear elasticity is for small "
                  "ones and leaves out what is quadratic in them, some %.0f "
                  "%% of the strain there.",
                  strain, 50. * strain)});
      if (rotation > large_deformation)
        warnings.push_back(
          {"rotation", rotation,
           format("the body turns by up to %.2g degrees: linear elasticity is for small "
                  "rotations, and makes a strain of %.2g of this one.",
                  rotation * 180. / numbers::PI, 0.5 * rotation * rotation)});
    }

    // Forces have the moments that they have on a body that has not turned, and what is
    // round rolls up beside where it lay.
    //
    // @param turn of a body that contact alone holds, radians.
    void add_turn(const double turn, const double coefficient, Warnings &warnings)
    {
      if (coefficient > 0. && turn > much_of_coefficient * coefficient)
        warnings.push_back(
          {"turn", turn,
           format("a body that contact alone holds turns by %.2g degrees, which is "
                  "%.2g of the friction angle: contact forces stay where they act on "
                  "bodies that have not turned, so that a round body may seem held "
                  "beyond what friction bears.",
                  turn * 180. / numbers::PI, turn / coefficient)});
    }

    // Σ u × f of each body, the moment that its forces have only where they come to, Nm.
    // Collective.
    std::vector<Tensor<1, 3>> moments_left_out(const LinearElasticity &elasticity,
                                               const LA::Vector &u)
    {
      const Body &body       = elasticity.body();
      const LA::Vector force = elasticity.internal_force(u);
      std::vector<double> sums(3 * body.pieces().size());
      for (const Body::Node &node : body.locally_owned_nodes())
        {
          Tensor<1, 3> f, moved;
          for (unsigned int c = 0; c < 3; ++c)
            {
              f[c]     = force(node.dofs[c]);
              moved[c] = u(node.dofs[c]);
            }
          const Tensor<1, 3> moment = cross_product_3d(moved, f);
          for (unsigned int c = 0; c < 3; ++c)
            sums[3 * node.piece + c] += moment[c];
        }
      Utilities::MPI::sum(sums, body.communicator(), sums);
      std::vector<Tensor<1, 3>> moments;
      for (std::size_t i = 0; i < sums.size(); i += 3)
        moments.push_back(Tensor<1, 3>({sums[i], sums[i + 1], sums[i + 2]}));
      return moments;
    }

    // Obstacles and other bodies take along what nothing holds, with no force: who means
    // to press has left out what a body is pressed against.
    void add_pushed(const Body &body, const std::vector<RigidMotion> &motions,
                    const ContactSurface &surface, const State &state, const Units &units,
                    Warnings &warnings)
    {
      Eigen::VectorXd forces =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(body.pieces().size()));
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        for (const unsigned int piece :
             surface.boundary_of(surface.nodes()[i]).pieces(body))
          forces(piece) += std::abs(state.lambda(i));
      for (unsigned int p = 0; p < motions.size(); ++p)
        {
          const Piece &piece = body.pieces()[p];
          double way         = 0.;
          for (unsigned int v = 0; v < 8; ++v)
            way = std::max(way, motions[p].at(piece.box.vertex(v)).norm());
          if (forces(p) <= no_force * forces.maxCoeff() &&
              way > rounding_of_way * body.diameter())
            warnings.push_back(
              {"push of " + piece.name, way,
               "body '" + piece.name + "' gives way as a whole, by up to " +
                 with_unit(format("%.2g", way), units.length) +
                 ", and bears no force: nothing is there that it could be pressed "
                 "against; hold it by 'Prescribed displacement', or say what else it may "
                 "touch."});
        }
    }

    // What a vector has along the axes about which a body is free to turn.
    Tensor<1, 3> along_free_axes(const FreeMotions &free, const unsigned int piece,
                                 const double radius, const Tensor<1, 3> &moment)
    {
      const auto [begin, n] = free.of(piece);
      Eigen::Matrix3Xd axes(3, n);
      for (Eigen::Index j = 0; j < n; ++j)
        {
          const auto motions = free.motions(Eigen::VectorXd::Unit(free.n(), begin + j));
          const auto &[way, turn, centre] = motions[piece];
          for (unsigned int c = 0; c < 3; ++c)
            axes(c, j) = turn.norm() * radius > rounding_of_axis ? turn[c] : 0.;
        }
      const Eigen::Vector3d along =
        axes * axes.completeOrthogonalDecomposition().solve(
                 Eigen::Vector3d(moment[0], moment[1], moment[2]));
      return Tensor<1, 3>({along(0), along(1), along(2)});
    }

    // Σ |λ| ‖x − c‖ of the nodes at which a body is touched or tied, with the centre c of
    // these forces, Nm: about the moment that contact can bear. No node is closer to c
    // than a part of the distance of nodes.
    double moment_of_contact(const ContactSurface &surface, const Body &body,
                             const State &state, const unsigned int piece)
    {
      std::vector<std::pair<const ContactNode *, double>> pressed;
      Tensor<1, 3> centre;
      double sum = 0.;
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        {
          const ContactNode &node         = surface.nodes()[i];
          const ContactBoundary &boundary = surface.boundary_of(node);
          const double force =
            boundary.is_tied() ? at_node(state.lambda, i).norm() : state.lambda(i);
          if (force <= 0. || boundary.pieces(body).count(piece) == 0)
            continue;
          pressed.emplace_back(&node, force);
          centre += force * node.position;
          sum += force;
        }
      double moment = 0.;
      for (const auto &[node, force] : pressed)
        moment += force * std::max((node->position - Point<3>(centre / sum)).norm(),
                                   std::sqrt(node->area) / 2.);
      return moment;
    }

    // A body that contact alone holds is held by moments that it has not where it is.
    void add_moments(const LinearElasticity &elasticity, const ContactSurface &surface,
                     const State &state, Warnings &warnings)
    {
      const Body &body   = elasticity.body();
      const auto moments = moments_left_out(elasticity, state.u);
      for (unsigned int p = 0; p < body.pieces().size(); ++p)
        {
          if (elasticity.free_motions().of(p).second == 0)
            continue;
          const double borne = moment_of_contact(surface, body, state, p);
          const double part  = along_free_axes(elasticity.free_motions(), p,
                                               body.pieces()[p].radius(), moments[p])
                                .norm() /
                              borne;
          if (borne > 0. && part > much_of_arm)
            warnings.push_back(
              {"moment of " + body.pieces()[p].name, part,
               "forces on body '" + body.pieces()[p].name +
                 format("' have a moment where it came to that they have not where it is "
                        "made, %.2g times what contact bears over its extent: were they "
                        "to move with the body, as a ball that rolls has them, it might "
                        "not be held.",
                        part)});
        }
    }

    // The box of each body where it came to. Collective.
    std::vector<BoundingBox<3>> boxes_at(const Body &body, const LA::Vector &u)
    {
      const std::size_t n = body.pieces().size();
      std::vector<double> largest(6 * n, -std::numeric_limits<double>::max());
      for (const Body::Node &node : body.locally_owned_nodes())
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double x = node.position[c] + u(node.dofs[c]);
            double &low    = largest[6 * node.piece + c];
            double &high   = largest[6 * node.piece + 3 + c];
            low            = std::max(low, -x);
            high           = std::max(high, x);
          }
      Utilities::MPI::max(largest, body.communicator(), largest);
      std::vector<BoundingBox<3>> boxes;
      for (std::size_t i = 0; i < largest.size(); i += 6)
        boxes.emplace_back(
          std::make_pair(Point<3>(-largest[i], -largest[i + 1], -largest[i + 2]),
                         Point<3>(largest[i + 3], largest[i + 4], largest[i + 5])));
      return boxes;
    }

    // By how much boxes overlap, negative if they are apart.
    double overlap(const BoundingBox<3> &a, const BoundingBox<3> &b)
    {
      double least = std::numeric_limits<double>::max();
      for (unsigned int c = 0; c < 3; ++c)
        least = std::min(least, std::min(a.upper_bound(c), b.upper_bound(c)) -
                                  std::max(a.lower_bound(c), b.lower_bound(c)));
      return least;
    }

    // Bodies that were apart and are no pair, where they came to.
    void add_passing(const Body &body, const ContactSurface &surface, const LA::Vector &u,
                     const Units &units, Warnings &warnings)
    {
      const std::size_t n = body.pieces().size();
      if (n == 1)
        return;
      const double rounding = rounding_of_box * body.diameter();
      const auto boxes      = boxes_at(body, u);
      for (unsigned int p = 0; p < n; ++p)
        for (unsigned int q = p + 1; q < n; ++q)
          {
            const Piece &first = body.pieces()[p], &second = body.pieces()[q];
            const double depth = overlap(boxes[p], boxes[q]);
            if (depth <= rounding || overlap(first.box, second.box) > -rounding ||
                std::any_of(surface.boundaries().begin(), surface.boundaries().end(),
                            [&](const ContactBoundary &pair) {
                              const auto pieces = pair.pieces(body);
                              return pair.is_pair() && pieces.count(p) > 0 &&
                                     pieces.count(q) > 0;
                            }))
              continue;
            warnings.push_back(
              {"way of " + first.name + " to " + second.name, depth,
               "bodies '" + first.name + "' and '" + second.name +
                 "', which are no contact pair, came to where they may be in one another "
                 "(the boxes around them overlap by " +
                 with_unit(format("%.2g", depth), units.length) +
                 "): nothing keeps them apart; pair their boundaries if they touch."});
          }
    }
  } // namespace

  void add_warnings_of_bodies(const LinearElasticity &elasticity,
                              const ContactSurface &surface, const State &state,
                              const Units &units, const bool has_steps,
                              Warnings &warnings)
  {
    add_deformation(largest_deformation(elasticity.body(), state.u), warnings);
    const FreeMotions &free = elasticity.free_motions();
    double turn             = 0.;
    const auto motions      = free.motions(elasticity.free_motion_of(state.u));
    for (const RigidMotion &motion : motions)
      turn = std::max(turn, motion.rotation.norm());
    add_turn(turn, surface.largest_coefficient(), warnings);
    if (free.n() > 0)
      {
        add_moments(elasticity, surface, state, warnings);
        if (!has_steps) // in which it may be on its way, or let go
          add_pushed(elasticity.body(), motions, surface, state, units, warnings);
      }
    add_passing(elasticity.body(), surface, state.u, units, warnings);
  }
} // namespace stiction
