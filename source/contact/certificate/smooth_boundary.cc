#include <stiction/contact/certificate/smooth_boundary.h>
#include <stiction/elasticity/mesh/body.h>

#include <deal.II/base/geometry_info.h>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Cell  = DoFHandler<3>::active_cell_iterator;
    using Place = SmoothBoundary::Place;

    constexpr double cosine_of_edge = 0.9396926; // of 20°

    LA::Vector zero_vector(const Body &body)
    {
      return {body.locally_owned_dofs(), body.locally_relevant_dofs(),
              body.communicator()};
    }

    // The edges of a cell from one of its vertices, along its directions.
    Tensor<1, 3> edge(const std::array<Point<3>, 8> &vertices, const unsigned int v,
                      const unsigned int d)
    {
      return vertices[v ^ (1u << d)] - vertices[v];
    }
  } // namespace

  SmoothBoundary::SmoothBoundary(const Body &body,
                                 const std::set<types::boundary_id> &ids)
    : body_(body)
  {
    for (const auto id : ids)
      normals_.emplace(id, zero_vector(body));
    for (const Cell &cell : body.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) && ids.count(cell->face(f)->boundary_id()) > 0)
            add_normals(cell, f);
    for (auto &[id, normals] : normals_)
      {
        normals.compress(VectorOperation::add);
        normals.update_ghost_values();
      }
  }

  std::array<Point<3>, 8> SmoothBoundary::vertices(const Cell &cell) const
  {
    std::array<Point<3>, 8> vertices;
    for (const unsigned int v : cell->vertex_indices())
      vertices[v] = body_.vertex_on_curve(cell, v);
    return vertices;
  }

  void SmoothBoundary::add_normals(const Cell &cell, const unsigned int f)
  {
    LA::Vector &normals = normals_.at(cell->face(f)->boundary_id());
    const auto places   = vertices(cell);
    // of the large cell where the other end hangs on it: the faces around a vertex must
    // have the same edges
    const auto whole_edge = [&](const unsigned int v, const unsigned int d) {
      const unsigned int end = v ^ (1u << d);
      const auto *others =
        body_.hanging_nodes().get_constraint_entries(cell->vertex_dof_index(end, 0));
      if (others != nullptr)
        for (const auto &other : *others)
          if (other.first == cell->vertex_dof_index(v, 0))
            return 2. * (cell->vertex(end) - cell->vertex(v));
      return edge(places, v, d);
    };
    for (unsigned int a = 0; a < 4; ++a)
      {
        const unsigned int v   = GeometryInfo<3>::face_to_cell_vertices(f, a);
        const Tensor<1, 3> one = whole_edge(v, (f / 2 + 1) % 3);
        const Tensor<1, 3> two = whole_edge(v, (f / 2 + 2) % 3);
        // with these lengths right on a sphere (N. Max, Weights for computing vertex
        // normals from facet normals, 1999)
        Tensor<1, 3> normal =
          cross_product_3d(one, two) / (one.norm_square() * two.norm_square());
        if (normal * edge(places, v, f / 2) > 0.)
          normal *= -1.;
        for (unsigned int c = 0; c < 3; ++c)
          normals(cell->vertex_dof_index(v, c)) += normal[c];
      }
  }

  SmoothBoundary::Face SmoothBoundary::face(const Cell &cell, const unsigned int f) const
  {
    std::array<unsigned int, 4> v;
    for (unsigned int a = 0; a < 4; ++a)
      v[a] = GeometryInfo<3>::face_to_cell_vertices(f, a);
    const auto places = vertices(cell);
    Tensor<1, 3> flat =
      cross_product_3d(places[v[3]] - places[v[0]], places[v[2]] - places[v[1]]);
    flat /= (flat * edge(places, v[0], f / 2) > 0. ? -1. : 1.) * flat.norm();

    const LA::Vector &normals = normals_.at(cell->face(f)->boundary_id());
    Face face;
    for (unsigned int a = 0; a < 4; ++a)
      {
        face[a] = {places[v[a]], Tensor<1, 3>()};
        // hanging ones have faces on one side alone
        for (const auto &[dof, weight] :
             body_.followed_by(cell->vertex_dof_index(v[a], 0)))
          face[a].normal += weight * normal(dof, normals, flat);
        face[a].normal /= face[a].normal.norm();
      }
    return face;
  }

  Tensor<1, 3> SmoothBoundary::normal(const types::global_dof_index first_dof,
                                      const LA::Vector &normals, const Tensor<1, 3> &flat)
  {
    Tensor<1, 3> normal;
    for (unsigned int c = 0; c < 3; ++c)
      normal[c] = normals(first_dof + c);
    const double length  = normal.norm();
    const bool is_smooth = length > 0. && normal * flat >= cosine_of_edge * length;
    return is_smooth ? normal / length : flat;
  }

  std::vector<Place> SmoothBoundary::at_points(const FEFaceValues<3> &values,
                                               const Cell &cell) const
  {
    const unsigned int f = values.get_face_number();
    std::vector<Place> places;
    for (const unsigned int q : values.quadrature_point_indices())
      places.push_back({values.quadrature_point(q), values.normal_vector(q)});
    if (values.get_fe().degree > 1)
      return places;
    const Face corners = face(cell, f);
    for (const unsigned int q : values.quadrature_point_indices())
      {
        std::array<double, 4> weights;
        for (unsigned int a = 0; a < 4; ++a)
          weights[a] =
            values.shape_value(3 * GeometryInfo<3>::face_to_cell_vertices(f, a), q);
        places[q] = at(corners, weights);
      }
    return places;
  }

  Place SmoothBoundary::at(const Face &face, const std::array<double, 4> &weights)
  {
    Place place{};
    for (unsigned int a = 0; a < 4; ++a)
      {
        place.position += weights[a] * face[a].position;
        place.normal += weights[a] * face[a].normal;
      }
    Tensor<1, 3> to_planes;
    for (unsigned int a = 0; a < 4; ++a)
      to_planes -= weights[a] * ((place.position - face[a].position) * face[a].normal) *
                   face[a].normal;
    place.position += 0.5 * to_planes;
    place.normal /= place.normal.norm();
    return place;
  }
} // namespace stiction
