#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/smooth_boundary.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/pairs/surface_face.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/simulation/warnings/facet_warnings.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the way that elastic bodies give.
    constexpr double much_of_way = 0.05;

    using Face = Triangulation<3>::face_iterator;

    Tensor<1, 3> area_vector(const Face &face)
    {
      return cross_product_3d(face->vertex(3) - face->vertex(0),
                              face->vertex(2) - face->vertex(1));
    }

    // The faces of a boundary on coarse cells. A triangle that was cut into three of them
    // is one facet.
    class Facets
    {
    public:
      Facets(const Body &body, const types::boundary_id id)
        : body_(body)
      {
        for (const auto &cell : body.triangulation().cell_iterators_on_level(0))
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
              add(cell, f, cell->face(f)->boundary_id() == id);
      }

      // How far the middle of a facet is from the smooth surface through its corners, if
      // forces act there, those beside it are off its plane alike and nodes within it are
      // on this plane; otherwise zero. Collective.
      double depth(const BoundingBox<3> &where) const
      {
        double depth = 0.;
        for (const auto &[cell, f] : faces_)
          if (cell->face(f)->bounding_box().get_neighbor_type(where) !=
              NeighborType::not_neighbors)
            depth = std::max(depth, depth_of(cell, f));
        for (const auto &[v, triangle] : centers_)
          if (triangle.normals.size() == 3 && rim_.count(v) == 0 &&
              where.point_inside(triangle.center))
            depth = std::max(depth, depth_of(triangle));
        return Utilities::MPI::max(depth,
                                   body_.communicator()); // refined on its own rank
      }

    private:
      using Cell = Triangulation<3>::cell_iterator;

      // What is around a vertex, the middle of a triangle if that is three faces.
      struct Triangle
      {
        Point<3> center;
        std::vector<std::pair<unsigned int, Point<3>>> corners; // across the faces
        std::vector<Tensor<1, 3>> normals;                      // of these, unit
      };

      void add(const Cell &cell, const unsigned int f, const bool is_own)
      {
        const Face face = cell->face(f);
        Tensor<1, 3> n  = area_vector(face);
        if (n * (face->center() - cell->center()) < 0.)
          n = -n;
        if (is_own)
          faces_.emplace_back(cell, f);
        for (unsigned int v = 0; v < 4; ++v)
          if (const unsigned int index = face->vertex_index(v); is_own)
            {
              normals_[index] += n;
              Triangle &around = centers_[index];
              around.center    = face->vertex(v);
              around.corners.emplace_back(face->vertex_index(3 - v), face->vertex(3 - v));
              around.normals.push_back(n / n.norm());
            }
          else
            rim_.insert(index);
      }

      double depth_of(const Cell &cell, const unsigned int f) const
      {
        const Face face = cell->face(f);
        if (!face->has_children() && (body_.dof_handler().get_fe().degree == 1 ||
                                      !cell->is_active() || !cell->is_locally_owned()))
          return 0.;
        std::vector<std::pair<unsigned int, Point<3>>> corners;
        for (unsigned int v = 0; v < 4; ++v)
          corners.emplace_back(face->vertex_index(v), face->vertex(v));
        const Tensor<1, 3> own = area_vector(face) / area_vector(face).norm();
        Point<3> unit_center(0.5, 0.5, 0.5);
        unit_center[f / 2] = f % 2;
        const Point<3> center =
          face->has_children()
            ? face->child(0)->vertex(3)
            : body_.mapping().transform_unit_to_real_cell(cell, unit_center);
        const double depth = depth_below(corners, own);
        return std::abs((center - face->center()) * own) < 0.1 * depth ? depth : 0.;
      }

      double depth_of(const Triangle &triangle) const
      {
        const Tensor<1, 3> &own = triangle.normals.front();
        for (const Tensor<1, 3> &other : triangle.normals)
          if (cross_product_3d(own, other).norm() > flat_kink)
            return 0.;
        return depth_below(triangle.corners, own);
      }

      // Of corners at the rim normals are means of one side alone.
      double depth_below(const std::vector<std::pair<unsigned int, Point<3>>> &corners,
                         const Tensor<1, 3> &own) const
      {
        double least = 1., least_of_all = 1., most = 0.;
        SmoothBoundary::Face smooth;
        Point<3> middle;
        for (const auto &[vertex, place] : corners)
          {
            const Tensor<1, 3> &sum = normals_.at(vertex);
            smooth.push_back({place, sum / sum.norm()});
            middle += place / static_cast<double>(corners.size());
            const double half = cross_product_3d(smooth.back().normal, own).norm();
            most              = std::max(most, half);
            least_of_all      = std::min(least_of_all, half);
            if (rim_.count(vertex) == 0)
              least = std::min(least, half);
          }
        if (least == 1.) // one row
          least = least_of_all;
        if (least < 0.5 * most || most < flat_kink || most > sharp_kink)
          return 0.;
        const std::vector<double> weights(corners.size(),
                                          1. / static_cast<double>(corners.size()));
        return SmoothBoundary::at(smooth, weights).position.distance(middle);
      }

      const Body &body_;
      std::vector<std::pair<Cell, unsigned int>> faces_;
      std::map<unsigned int, Tensor<1, 3>> normals_; // sums
      std::map<unsigned int, Triangle> centers_;
      std::set<unsigned int> rim_; // vertices that are of other boundaries as well
    };

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

    // Surfaces that are meshed alike have the same facets, which fit.
    bool fits(const ContactSurface &surface, const std::size_t b, const double depth)
    {
      return surface.boundaries()[b].is_pair() &&
             std::all_of(surface.nodes().begin(), surface.nodes().end(),
                         [&](const ContactNode &node) {
                           return node.boundary != b ||
                                  std::abs(node.mesh_gap) < 0.1 * depth;
                         });
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
        if ((boundary.obstacle() == nullptr && !boundary.is_pair()) || places.empty() ||
            boundary.is_tied() || !boundary.keeps_mesh_gap())
          continue;
        double depth = Facets(body, boundary.id()).depth(BoundingBox<3>(places));
        for (const types::boundary_id partner : boundary.partners())
          depth = std::max(depth, Facets(body, partner).depth(BoundingBox<3>(places)));
        if (way > 0. && depth > much_of_way * way && !fits(surface, b, depth))
          warnings.push_back(
            {"facets of " + boundary.name(), depth,
             "nodes of '" + boundary.name() +
               (boundary.is_pair() ? "' or '" + boundary.partner_name() : "") +
               "' are on facets, up to " +
               with_unit(format("%.2g", depth), units.length) +
               " off the round surface that these stand for, while bodies give " +
               with_unit(format("%.2g", way), units.length) +
               ": pressures follow the facets; a mesh of second order" +
               (body.cut_elements().empty()
                  ? ", or one with as many cells instead of refinement,"
                  : "") +
               " has its nodes on the surface."});
      }
  }
} // namespace stiction
