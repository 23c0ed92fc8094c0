// obstacle.vtu: what the contact boundaries may touch, for pictures.

#include "zero_set.h"

#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/obstacles/obstacle.h>
#include <stiction/contact/obstacles/stl_file.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/results/vtu.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // A polygon with the contact boundary that it belongs to.
    struct ObstacleFace
    {
      types::boundary_id boundary;
      std::vector<Point<3>> corners;

      template<typename Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &boundary &corners;
      }
    };

    using ObstacleFaces = std::vector<ObstacleFace>;

    // From a node of this boundary to the foundation; nothing where it is no
    // contact node of it.
    std::optional<Tensor<1, 3>> way_to_foundation(const Body &body,
                                                  const ContactSurface &surface,
                                                  const types::boundary_id boundary,
                                                  const types::global_dof_index first_dof)
    {
      Tensor<1, 3> way;
      for (const auto &[dof, weight] : body.followed_by(first_dof))
        {
          const Eigen::Index i = surface.node_of(dof);
          if (i < 0 || surface.boundary_of(surface.nodes()[i]).id() != boundary)
            return std::nullopt;
          const ContactNode &node = surface.nodes()[i];
          way += weight * node.gap * node.normal;
        }
      return way;
    }

    // The faces of the contact boundaries with a foundation, moved to it; on
    // rank 0 those of all ranks. Corners that are no contact nodes are moved
    // like the others of their face. Collective.
    ObstacleFaces foundations(const Body &body, const ContactSurface &surface,
                              const State &state)
    {
      ObstacleFaces mine;
      for (const auto &cell : body.locally_owned_cells())
        for (const auto &face : cell->face_iterators())
          {
            const types::boundary_id boundary = face->boundary_id();
            if (!face->at_boundary() || !surface.is_contact_boundary(boundary) ||
                surface.boundary(boundary).obstacle() != nullptr ||
                surface.boundary(boundary).is_pair())
              continue;
            std::array<std::optional<Tensor<1, 3>>, 4> ways;
            Tensor<1, 3> mean;
            unsigned int n = 0;
            for (unsigned int v = 0; v < 4; ++v)
              {
                ways[v] = way_to_foundation(body, surface, boundary,
                                            face->vertex_dof_index(v, 0));
                mean += ways[v].value_or(Tensor<1, 3>());
                n += ways[v] ? 1 : 0;
              }
            if (n == 0)
              continue;
            mine.push_back({boundary, {}});
            for (const unsigned int v : {0, 1, 3, 2}) // around the face
              mine.back().corners.push_back(
                face->vertex(v) + ways[v].value_or(mean / n) +
                surface.obstacle_displacement(boundary, state.distances));
          }
      ObstacleFaces all;
      for (const auto &theirs : Utilities::MPI::gather(body.communicator(), mine))
        all.insert(all.end(), theirs.begin(), theirs.end());
      return all;
    }

    // The distance from an obstacle as it is, moved and with its initial gap.
    class MovedObstacle
    {
    public:
      MovedObstacle(const ContactBoundary &boundary, const Tensor<1, 3> &displacement)
        : boundary_(boundary)
        , displacement_(displacement)
      {
      }

      // ψ is a distance to first order, the gradient a unit vector. Nothing
      // where the user's formulas have no value or the gradient no direction.
      std::optional<Obstacle::Value> at(const Point<3> &p) const
      {
        try
          {
            const Point<3> from   = p - displacement_;
            Obstacle::Value value = boundary_.obstacle()->at(from);
            const double slope    = value.gradient.norm();
            if (!(slope > 0.))
              return std::nullopt;
            value.psi = value.psi / slope + boundary_.initial_gap(from);
            value.gradient /= slope;
            return value;
          }
        catch (const InputError &)
          {
            return std::nullopt;
          }
      }

      // The point of the surface near another one, which is kept if there is
      // none within this reach.
      Point<3> nearest(const Point<3> &p, const double reach) const
      {
        Point<3> x = p;
        for (unsigned int step = 0; step < 5; ++step)
          {
            const auto value = at(x);
            if (!value)
              return p;
            if (std::abs(value->psi) <= 1e-12 * reach)
              break;
            x -= value->psi * value->gradient;
          }
        return x.distance(p) <= reach ? x : p;
      }

    private:
      const ContactBoundary &boundary_;
      const Tensor<1, 3> displacement_;
    };

    // Where to look for the surface of an obstacle: around the nodes of the
    // contact boundary, and where the nearest of them meets it.
    BoundingBox<3> neighbourhood(const ContactSurface &surface, const State &state,
                                 const std::size_t boundary)
    {
      std::vector<Point<3>> points;
      double smallest = std::numeric_limits<double>::max();
      Point<3> touched;
      const Eigen::VectorXd gaps = surface.motion().offset(state.distances);
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        if (surface.nodes()[i].boundary == boundary)
          {
            const ContactNode &node = surface.nodes()[i];
            points.push_back(node.position);
            if (gaps(i) < smallest)
              {
                smallest = gaps(i);
                touched  = node.position + gaps(i) * node.normal;
              }
          }
      points.push_back(touched);
      BoundingBox<3> box(points);
      const double length = diameter(box);
      box.extend(length > 0. ? 0.2 * length
                             : 0.2 * surface.boundaries()[boundary].body_size());
      return box;
    }

    // The zero set of the distance, its vertices moved onto the surface.
    void add_zero_set(const MovedObstacle &obstacle, const BoundingBox<3> &box,
                      const types::boundary_id boundary, ObstacleFaces &faces)
    {
      const TriangulatedSurface surface = zero_set(
        [&](const Point<3> &p) -> std::optional<double> {
          const auto value = obstacle.at(p);
          return value ? std::optional<double>(value->psi) : std::nullopt;
        },
        box);
      const double reach =
        std::max({box.side_length(0), box.side_length(1), box.side_length(2)}) / 40.;
      for (const auto &triangle : surface.triangles)
        {
          faces.push_back({boundary, {}});
          for (const auto vertex : triangle)
            faces.back().corners.push_back(
              obstacle.nearest(surface.vertices[vertex], reach));
        }
    }

    // The triangles of an obstacle that is made of them.
    void add_triangles(const TriangulatedSurface &triangulated,
                       const ContactBoundary &boundary, const Tensor<1, 3> &displacement,
                       ObstacleFaces &faces)
    {
      for (const auto &triangle : triangulated.triangles)
        {
          std::vector<Point<3>> points;
          for (const auto vertex : triangle)
            points.push_back(triangulated.vertices[vertex]);
          Tensor<1, 3> normal =
            cross_product_3d(points[1] - points[0], points[2] - points[0]);
          normal /= normal.norm();
          try
            {
              for (Point<3> &p : points)
                p += displacement - boundary.initial_gap(p) * normal;
            }
          catch (const InputError &)
            {
              continue; // no gap is defined there
            }
          faces.push_back({boundary.id(), points});
        }
    }

    void write_faces(std::ostream &file, const ObstacleFaces &faces)
    {
      file.precision(9);
      std::size_t n_points = 0;
      for (const ObstacleFace &face : faces)
        n_points += face.corners.size();
      const auto write_array = [&](const std::string &attributes, const auto &write) {
        file << "<DataArray " << attributes << " format=\"ascii\">\n";
        for (const ObstacleFace &face : faces)
          write(face);
        file << "</DataArray>\n";
      };

      file << "<?xml version=\"1.0\"?>\n"
           << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
              "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
           << "<Piece NumberOfPoints=\"" << n_points << "\" NumberOfCells=\""
           << faces.size() << "\">\n<Points>\n";
      write_array("type=\"Float64\" NumberOfComponents=\"3\"",
                  [&](const ObstacleFace &face) {
                    for (const Point<3> &p : face.corners)
                      file << p << '\n';
                  });
      file << "</Points>\n<Cells>\n";
      std::size_t point = 0, offset = 0;
      write_array("type=\"Int64\" Name=\"connectivity\"", [&](const ObstacleFace &face) {
        for (std::size_t k = 0; k < face.corners.size(); ++k)
          file << point++ << (k + 1 < face.corners.size() ? ' ' : '\n');
      });
      write_array("type=\"Int64\" Name=\"offsets\"", [&](const ObstacleFace &face) {
        file << (offset += face.corners.size()) << '\n';
      });
      write_array("type=\"UInt8\" Name=\"types\"", [&](const ObstacleFace &face) {
        file << (face.corners.size() == 3 ? 5 : 9) << '\n';
      });
      file << "</Cells>\n<CellData Scalars=\"boundary\">\n";
      write_array("type=\"Int32\" Name=\"boundary\"",
                  [&](const ObstacleFace &face) { file << face.boundary << '\n'; });
      file << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    }
  } // namespace

  void write_obstacles(const std::string &directory, const LinearElasticity &elasticity,
                       const ContactSurface &surface, const State &state,
                       const std::string &tag)
  {
    if (!surface.has_obstacles())
      return; // both sides are in the other files
    const Body &body    = elasticity.body();
    ObstacleFaces faces = foundations(body, surface, state);
    do_on_first_rank(body.communicator(), [&]() {
      for (std::size_t b = 0; b < surface.boundaries().size(); ++b)
        {
          const ContactBoundary &boundary = surface.boundaries()[b];
          const Tensor<1, 3> displacement =
            surface.obstacle_displacement(boundary.id(), state.distances);
          if (boundary.obstacle() == nullptr)
            continue;
          if (const auto *triangles = boundary.obstacle()->triangles())
            add_triangles(*triangles, boundary, displacement, faces);
          else
            add_zero_set(MovedObstacle(boundary, displacement),
                         neighbourhood(surface, state, b), boundary.id(), faces);
        }
      if (!faces.empty()) // a formula with a jump has no surface
        write_file(directory + "/obstacle" + tag + ".vtu",
                   [&](std::ostream &file) { write_faces(file, faces); });
    });
  }
} // namespace stiction
