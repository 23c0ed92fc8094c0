#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/smooth_boundary.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/simulation/warnings/facet_warnings.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the way that elastic bodies give.
    constexpr double much_of_way = 0.1;

    // Sines of half of the angle between facets: less is flat, more an edge, of 40
    // degrees.
    constexpr double flat = 1e-3, edge = 0.34;

    using Face = Triangulation<3>::face_iterator;

    Tensor<1, 3> area_vector(const Face &face)
    {
      return cross_product_3d(face->vertex(3) - face->vertex(0),
                              face->vertex(2) - face->vertex(1));
    }

    // The nodes of a boundary on which forces act.
    std::vector<Point<3>> places_of_contact(const ContactSurface &surface,
                                            const std::size_t b, const State &state)
    {
      const double largest = state.lambda.head(surface.n_nodes()).maxCoeff();
      std::vector<Point<3>> points;
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        if (surface.nodes()[i].boundary == b && state.lambda(i) > no_force * largest)
          points.push_back(surface.nodes()[i].position);
      return points;
    }

    // How far the middle of a facet is from the smooth surface through its corners, if
    // those beside it are off its plane alike and nodes within it are on this plane;
    // otherwise zero.
    double depth_of(const Triangulation<3>::cell_iterator &cell, const unsigned int f,
                    const Body &body, const std::map<unsigned int, Tensor<1, 3>> &normals)
    {
      const Face face = cell->face(f);
      if (!face->has_children() && (body.dof_handler().get_fe().degree == 1 ||
                                    !cell->is_active() || !cell->is_locally_owned()))
        return 0.;
      const Tensor<1, 3> own = area_vector(face) / area_vector(face).norm();
      double least = 1., most = 0.;
      SmoothBoundary::Face corners;
      for (unsigned int v = 0; v < 4; ++v)
        {
          const Tensor<1, 3> &sum = normals.at(face->vertex_index(v));
          corners.push_back({face->vertex(v), sum / sum.norm()});
          const double half = cross_product_3d(corners.back().normal, own).norm();
          least             = std::min(least, half);
          most              = std::max(most, half);
        }
      const double depth = SmoothBoundary::at(corners, {0.25, 0.25, 0.25, 0.25})
                             .position.distance(face->center());
      Point<3> unit_center(0.5, 0.5, 0.5);
      unit_center[f / 2] = f % 2;
      const Point<3> center =
        face->has_children()
          ? face->child(0)->vertex(3)
          : body.mapping().transform_unit_to_real_cell(cell, unit_center);
      const bool is_flat = std::abs((center - face->center()) * own) < 0.1 * depth;
      return least > 0.5 * most && most > flat && most < edge && is_flat ? depth : 0.;
    }

    // The largest such depth where forces act. Collective.
    double depth_of_facets(const Body &body, const types::boundary_id id,
                           const BoundingBox<3> &where)
    {
      std::map<unsigned int, Tensor<1, 3>> normals;
      const auto for_each_facet = [&](const auto &callback) {
        for (const auto &cell : body.triangulation().cell_iterators_on_level(0))
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == id)
              callback(cell, f);
      };
      for_each_facet([&](const auto &cell, const unsigned int f) {
        const Face face = cell->face(f);
        Tensor<1, 3> n  = area_vector(face);
        if (n * (face->center() - cell->center()) < 0.)
          n = -n;
        for (unsigned int v = 0; v < 4; ++v)
          normals[face->vertex_index(v)] += n;
      });
      double depth = 0.;
      for_each_facet([&](const auto &cell, const unsigned int f) {
        if (cell->face(f)->bounding_box().get_neighbor_type(where) !=
            NeighborType::not_neighbors)
          depth = std::max(depth, depth_of(cell, f, body, normals));
      });
      return Utilities::MPI::max(depth, body.communicator()); // refined on its own rank
    }
  } // namespace

  void add_warnings_of_facets(const Body &body, const ContactSurface &surface,
                              const State &state, const double way, const Units &units,
                              Warnings &warnings)
  {
    for (std::size_t b = 0; b < surface.boundaries().size(); ++b)
      {
        const ContactBoundary &boundary = surface.boundaries()[b];
        const auto places               = places_of_contact(surface, b, state);
        if (boundary.obstacle() == nullptr || places.empty())
          continue;
        const double depth = depth_of_facets(body, boundary.id(), BoundingBox<3>(places));
        if (way > 0. && depth > much_of_way * way)
          warnings.push_back(
            {"facets of " + boundary.name(), depth,
             "nodes of '" + boundary.name() + "' are on facets, up to " +
               with_unit(format("%.2g", depth), units.length) +
               " off the round surface that these stand for, while bodies give " +
               with_unit(format("%.2g", way), units.length) +
               ": pressures follow the facets; a mesh of second order, or one with as "
               "many "
               "cells instead of refinement, has its nodes on the surface."});
      }
  }
} // namespace stiction
