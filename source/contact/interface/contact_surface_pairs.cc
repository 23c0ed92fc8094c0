// The contact boundaries that are pairs: which side is the slave, and what is opposite.

#include <stiction/base/errors.h>
#include <stiction/base/log.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/pairs/held_slaves.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/contact/pairs/rigid_turn.h>
#include <stiction/contact/pairs/slave_side.h>
#include <stiction/contact/pairs/surface_face.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the area around a node of a pair: with less opposite it carries no forces.
    constexpr double least_cover = 1e-3;

    // Of the area of a surface: more than the first is all of it, less than the second is
    // a smaller one. Facets of round surfaces do not cover each other to the last digit.
    constexpr double all_of_it = 0.999, all_of_facets = 0.98, smaller = 0.99;

    // Of the largest area of a node: less is a sliver, whose gap may be anything.
    constexpr double sliver = 1e-3;

    // Of a cosine: normals within it are those of a flat surface, whose area stays what
    // it is when the mesh is refined.
    constexpr double flat = 0.99;

    bool is_flat(const std::vector<SurfaceFace> &faces)
    {
      return std::all_of(faces.begin(), faces.end(), [&](const SurfaceFace &face) {
        return face.normal() * faces.front().normal() > flat;
      });
    }

    double area(const std::vector<SurfaceFace> &faces)
    {
      double sum = 0.;
      for (const SurfaceFace &face : faces)
        sum += face.area();
      return sum;
    }

    double mean_diameter(const std::vector<SurfaceFace> &faces)
    {
      double size = 0.;
      for (const SurfaceFace &face : faces)
        size += face.diameter() / static_cast<double>(faces.size());
      return size;
    }

    double largest_gap(const Mortar &mortar)
    {
      return mortar.slaves.empty() ? 0. : mortar.gaps.cwiseAbs().maxCoeff();
    }

    // Whether a surface ends within another one, which goes on beyond its edges: flat
    // ones, and curved ones that fit, as a hub on its shaft.
    bool ends_within(const LinearElasticity &elasticity,
                     const std::vector<SurfaceFace> &inner,
                     const std::vector<SurfaceFace> &outer)
    {
      if (area(inner) >= smaller * area(outer))
        return false;
      const auto covered = [&](const Mortar &mortar, const std::vector<SurfaceFace> &of) {
        return mortar.areas.sum() / area(of);
      };
      const Mortar mortar(elasticity, inner, outer);
      if (is_flat(inner) && is_flat(outer))
        return covered(mortar, inner) > all_of_it;
      // coarse facets have less area than fine ones of the same surface
      return covered(mortar, inner) > all_of_facets &&
             largest_gap(mortar) < mean_diameter(inner) &&
             covered(Mortar(elasticity, outer, inner), outer) < smaller;
    }

    // Forces act at nodes of the slave side, so that a contact ends where it should if
    // that is the side with the edge.
    SlaveSide best_side(const LinearElasticity &elasticity,
                        const std::vector<SurfaceFace> &first,
                        const std::vector<SurfaceFace> &second)
    {
      const SlaveSide side = choose_slave_side(first, second);
      const bool has_edge  = side.is_first ? ends_within(elasticity, second, first)
                                           : ends_within(elasticity, first, second);
      return has_edge ? side.other("the side that ends within the other") : side;
    }

    // The smallest edge of the boxes around the bodies at two boundaries.
    double thinnest(const Body &body, const ContactBoundary &pair)
    {
      double least = pair.body_size();
      for (const auto &cell : body.triangulation().cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() &&
              (face->boundary_id() == pair.id() || face->boundary_id() == pair.partner()))
            for (unsigned int d = 0; d < 3; ++d)
              least =
                std::min(least, body.pieces()[body.piece_of(cell)].box.side_length(d));
      return least;
    }

    // Of the size of faces: what is between the sides of a tie counts as rigid.
    constexpr double widest_tie = 0.25;

    // Throws InputError if a tied pair is too far apart to be one.
    void require_close(const ContactBoundary &pair, const Mortar &mortar,
                       const std::vector<SurfaceFace> &slaves)
    {
      const double size = mean_diameter(slaves), distance = largest_gap(mortar);
      if (distance > widest_tie * size)
        throw InputError(
          pair.source().describe("Friction/Law") + ", boundary '" + pair.name() +
          "' is up to " + format("%.3g", distance) + " away from '" +
          pair.partner_name() + "', to which it is tied, must be within " +
          format("%.3g", widest_tie * size) +
          ", a quarter of the size of its faces: what is between would count as "
          "rigid.");
    }

    // Throws InputError if the sides of a pair overlap by more than a body is thick.
    void require_side_by_side(const ContactBoundary &pair, const Mortar &mortar,
                              const Body &body)
    {
      if (mortar.slaves.empty())
        return;
      const double thickness = thinnest(body, pair),
                   least     = sliver * mortar.areas.maxCoeff();
      const double overlap =
        -(mortar.areas.array() < least).select(0., mortar.gaps).minCoeff();
      if (overlap >= thickness)
        throw InputError(pair.source().describe("Boundary conditions/Obstacle") +
                         ", boundary '" + pair.name() + "' is " +
                         format("%.3g", overlap) + " behind '" + pair.partner_name() +
                         "', and a body of both is only " + format("%.3g", thickness) +
                         " thick, must lie opposite to it but for a small interference.");
    }

    // The side that the user says, or the best one, unless another bears fewer forces or
    // closes no circle.
    //
    // rank: of a boundary, higher the more forces of others it has to bear.
    template<typename Rank, typename BodiesAt>
    SlaveSide choose_side(const ContactBoundary &pair, const SlaveSide &best,
                          const Rank &rank, const BodiesAt &bodies_at,
                          const SlaveOrder &order)
    {
      const auto slave  = best.is_first ? pair.id() : pair.partner();
      const auto master = best.is_first ? pair.partner() : pair.id();
      SlaveSide side    = best;
      if (pair.slave_side() != "automatic")
        {
          const bool is_best = (pair.slave_side() == "boundary") == best.is_first;
          side               = is_best ? best : best.other("");
          side.reason        = "as 'Slave side' says";
        }
      else if (rank(slave) > rank(master))
        side = best.other("the side that bears no other ones");
      else if (!best.is_much_softer() && rank(slave) == rank(master) &&
               order.closes_circle(bodies_at(slave), bodies_at(master)) &&
               !order.closes_circle(bodies_at(master), bodies_at(slave)))
        side = best.other("the side that closes no circle of bodies");
      if (side.is_much_stiffer())
        side.reason += ", although it is the stiffer one, for which newton "
                       "multigrid takes many iterations";
      return side;
    }
  } // namespace

  void ContactSurface::join_pairs(const LinearElasticity &elasticity)
  {
    // a boundary that stands in several of them can be the slave of one alone
    std::multiset<types::boundary_id> sides;
    std::set<types::boundary_id> with_forces;
    for (const ContactBoundary &boundary : boundaries_)
      if (boundary.is_pair())
        sides.insert({boundary.id(), boundary.partner()});
      else
        with_forces.insert(boundary.id());
    const auto rank = [&](const types::boundary_id id) {
      return with_forces.count(id) > 0 ? 2 : sides.count(id) > 1 ? 1 : 0;
    };
    mortars_.resize(boundaries_.size());
    SlaveOrder order; // of bodies
    const auto bodies_at = [&](const types::boundary_id id) {
      return elasticity.body().pieces_at(id);
    };
    for (const ContactBoundary &boundary : boundaries_)
      if (boundary.is_pair() && boundary.slave_side() == "boundary")
        order.add(bodies_at(boundary.id()), bodies_at(boundary.partner()));
      else if (boundary.is_pair() && boundary.slave_side() == "obstacle")
        order.add(bodies_at(boundary.partner()), bodies_at(boundary.id()));
    for (std::size_t b = 0; b < boundaries_.size(); ++b)
      if (ContactBoundary &boundary = boundaries_[b]; boundary.is_pair())
        {
          auto first           = surface_faces(elasticity, boundary.id());
          auto second          = surface_faces(elasticity, boundary.partner());
          const SlaveSide best = boundary.slave_side() == "automatic"
                                   ? best_side(elasticity, first, second)
                                   : choose_slave_side(first, second);
          const SlaveSide side = choose_side(boundary, best, rank, bodies_at, order);
          boundary.take_side(side.is_first, side.reason);
          if (!with_forces.insert(boundary.id()).second)
            throw InputError(
              boundary.source().describe("Boundary conditions/Slave side") +
              ", boundary '" + boundary.name() +
              "' would bear the forces of its pair with '" + boundary.partner_name() +
              "' and those of another contact, must do so once: say the "
              "other side, or make boundaries of their own of the parts.");
          if (!side.is_first)
            std::swap(first, second);
          mortars_[b]      = std::make_unique<Mortar>(elasticity, first, second);
          const auto slave = boundary.id();
          if (boundary.is_tied())
            {
              with_forces.erase(boundary.id());
              tie(b, elasticity, first, second);
              with_forces.insert(boundary.id());
            }
          const SlaveSide taken = boundary.id() == slave ? side : side.other("");
          has_stiff_slaves_     = has_stiff_slaves_ || taken.is_much_stiffer();
          order.add(bodies_at(boundary.id()), bodies_at(boundary.partner()));
          require_side_by_side(boundary, *mortars_[b], elasticity.body());
        }
  }

  void ContactSurface::tie(const std::size_t b, const LinearElasticity &elasticity,
                           const std::vector<SurfaceFace> &slaves,
                           const std::vector<SurfaceFace> &masters)
  {
    ContactBoundary &boundary = boundaries_[b];
    require_close(boundary, *mortars_[b], slaves);
    const unsigned int lost = n_held_alone(elasticity, *mortars_[b]);
    if (lost == 0)
      return;
    auto other = std::make_unique<Mortar>(elasticity, masters, slaves);
    if (boundary.slave_side() == "automatic" &&
        !is_contact_boundary(boundary.partner()) && n_held_alone(elasticity, *other) == 0)
      {
        mortars_[b] = std::move(other);
        boundary.take_side(false, "the side that is held less");
        return;
      }
    throw InputError(
      boundary.source().describe("Boundary conditions/Prescribed displacement") +
      ", holds " + std::to_string(lost) + " nodes of boundary '" + boundary.name() +
      "', but not those of '" + boundary.partner_name() +
      "' to which they are tied, so that the tie would be lost there, must "
      "hold both, or 'Slave side' must be the other one.");
  }

  bool ContactSurface::place_in_pair(ContactNode &node) const
  {
    const Mortar &mortar = *mortars_[node.boundary];
    const Eigen::Index i = mortar.row_of(node.first_dof);
    if (i < 0 || mortar.areas(i) < least_cover * node.area)
      return false;
    node.cover          = mortar.areas(i) / node.area;
    node.area           = mortar.areas(i);
    node.mesh_gap       = mortar.gaps(i);
    node.youngs_modulus = std::min(node.youngs_modulus, mortar.youngs_moduli(i));
    const ContactBoundary &boundary = boundaries_[node.boundary];
    node.gap                        = boundary.initial_gap(node.position) +
               (boundary.keeps_mesh_gap() && !boundary.is_tied() ? node.mesh_gap : 0.);
    return true;
  }

  ContactOperator::OtherSide ContactSurface::other_side(
    const LinearElasticity &elasticity, const DofSubset &own,
    const std::vector<ContactNode> &nodes) const
  {
    const auto n_rows = static_cast<Eigen::Index>(nodes.size());
    std::map<types::global_dof_index, Eigen::Index> column;
    for (const auto &mortar : mortars_)
      if (mortar)
        for (const auto dof : mortar->masters)
          column.emplace(dof, 0);
    if (column.empty())
      return {};
    std::vector<types::global_dof_index> masters;
    for (auto &[dof, number] : column)
      {
        number = static_cast<Eigen::Index>(masters.size());
        masters.push_back(dof);
      }
    using Matrix        = decltype(Mortar::weights);
    const auto by_nodes = [&](const Matrix Mortar::*const of_mortar) {
      std::vector<Eigen::Triplet<double>> entries;
      for (Eigen::Index i = 0; i < n_rows; ++i)
        if (const Mortar *const mortar = mortars_[nodes[i].boundary].get())
          for (Matrix::InnerIterator a(mortar->*of_mortar,
                                       mortar->row_of(nodes[i].first_dof));
               a; ++a)
            entries.emplace_back(i, column.at(mortar->masters[a.col()]), a.value());
      Matrix matrix(n_rows, static_cast<Eigen::Index>(masters.size()));
      matrix.setFromTriplets(entries.begin(), entries.end());
      return matrix;
    };

    ContactOperator::OtherSide other;
    other.dofs         = DofSubset::of_nodes(masters);
    LA::Vector is_free = elasticity.zero_vector();
    for (const auto dof : other.dofs.dofs())
      if (is_free.in_local_range(dof) && !elasticity.is_prescribed(dof))
        is_free(dof) = 1.;
    other.is_free     = other.dofs.restriction(is_free);
    other.weights     = by_nodes(&Mortar::weights);
    LA::Vector places = elasticity.zero_vector();
    for (const Body::Node &node : elasticity.body().locally_owned_nodes())
      for (unsigned int c = 0; c < 3; ++c)
        places(node.dofs[c]) = node.position[c];
    std::vector<unsigned int> pairs;
    for (const ContactNode &node : nodes)
      pairs.push_back(node.boundary);
    other.A =
      with_rigid_turns(other.weights, by_nodes(&Mortar::overlaps),
                       own.restriction(places), other.dofs.restriction(places), pairs);
    return other;
  }

  void ContactSurface::find_weights_of_other_side()
  {
    if (!B_.has_other_side())
      return; // Eigen knows no product of sparse matrices without columns
    const auto &other = B_.other_side();
    for (Eigen::Index j = 0; j < other.weights.cols(); ++j)
      opposite_node_of_dof_[other.dofs.dofs()[j]] = j;
    Eigen::VectorXd areas(n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      areas(i) = nodes_[i].area;
    to_other_side_                 = other.weights.transpose() * areas.asDiagonal();
    const Eigen::VectorXd of_nodes = to_other_side_ * Eigen::VectorXd::Ones(n_nodes());
    for (Eigen::Index j = 0; j < of_nodes.size(); ++j)
      to_other_side_.row(j) *= of_nodes(j) > 0. ? 1. / of_nodes(j) : 0.;
  }
} // namespace stiction
