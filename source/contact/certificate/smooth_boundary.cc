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
    const FiniteElement<3> &fe = body.dof_handler().get_fe();
    if (fe.degree > 1)
      at_nodes_ = std::make_unique<FEFaceValues<3>>(
        body.mapping(), fe,
        Quadrature<2>(fe.base_element(0).get_unit_face_support_points()),
        update_quadrature_points | update_normal_vectors);
    for (const auto id : ids)
      normals_.emplace(id, zero_vector(body));
    for (const Cell &cell : body.locally_owned_cells())
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
    if (at_nodes_)
      {
        const auto dofs = first_dofs(cell, f);
        at_nodes_->reinit(cell, f);
        for (unsigned int a = 0; a < dofs.size(); ++a)
          for (unsigned int c = 0; c < 3; ++c)
            normals(dofs[a] + c) += at_nodes_->normal_vector(a)[c];
        return;
      }
    const auto places = vertices(cell);
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

  std::vector<types::global_dof_index> SmoothBoundary::first_dofs(
    const Cell &cell, const unsigned int f) const
  {
    const FiniteElement<3> &fe = body_.dof_handler().get_fe();
    std::vector<types::global_dof_index> all(fe.n_dofs_per_cell()), first;
    cell->get_dof_indices(all);
    for (unsigned int i = 0; i < fe.n_dofs_per_face(f); i += 3)
      first.push_back(all[fe.face_to_cell_index(i, f)]);
    return first;
  }

  SmoothBoundary::Face SmoothBoundary::as_it_is(const Cell &cell,
                                                const unsigned int f) const
  {
    Face face;
    if (at_nodes_)
      {
        at_nodes_->reinit(cell, f);
        for (const unsigned int a : at_nodes_->quadrature_point_indices())
          face.push_back({at_nodes_->quadrature_point(a), at_nodes_->normal_vector(a)});
        return face;
      }
    const auto places = vertices(cell);
    for (unsigned int a = 0; a < 4; ++a)
      face.push_back({places[GeometryInfo<3>::face_to_cell_vertices(f, a)], {}});
    Tensor<1, 3> flat    = cross_product_3d(face[3].position - face[0].position,
                                            face[2].position - face[1].position);
    const unsigned int v = GeometryInfo<3>::face_to_cell_vertices(f, 0);
    flat /= (flat * edge(places, v, f / 2) > 0. ? -1. : 1.) * flat.norm();
    for (Place &corner : face)
      corner.normal = flat;
    return face;
  }

  SmoothBoundary::Face SmoothBoundary::face(const Cell &cell, const unsigned int f) const
  {
    const LA::Vector &normals = normals_.at(cell->face(f)->boundary_id());
    const auto dofs           = first_dofs(cell, f);
    Face face                 = as_it_is(cell, f);
    for (unsigned int a = 0; a < face.size(); ++a)
      {
        Tensor<1, 3> mean;
        // hanging ones have faces on one side alone
        for (const auto &[dof, weight] : body_.followed_by(dofs[a]))
          mean += weight * normal(dof, normals, face[a].normal);
        face[a].normal = mean / mean.norm();
      }
    return face;
  }

  Tensor<1, 3> SmoothBoundary::normal(const types::global_dof_index first_dof,
                                      const LA::Vector &normals, const Tensor<1, 3> &own)
  {
    Tensor<1, 3> normal;
    for (unsigned int c = 0; c < 3; ++c)
      normal[c] = normals(first_dof + c);
    const double length  = normal.norm();
    const bool is_smooth = length > 0. && normal * own >= cosine_of_edge * length;
    return is_smooth ? normal / length : own;
  }

  std::vector<Place> SmoothBoundary::at_points(const FEFaceValues<3> &values,
                                               const Cell &cell) const
  {
    const unsigned int f = values.get_face_number();
    const Face nodes     = face(cell, f);
    std::vector<double> weights(nodes.size());
    std::vector<Place> places;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        for (unsigned int a = 0; a < nodes.size(); ++a)
          weights[a] =
            values.shape_value(values.get_fe().face_to_cell_index(3 * a, f), q);
        places.push_back(at(nodes, weights));
      }
    return places;
  }

  Place SmoothBoundary::at(const Face &face, const std::vector<double> &weights)
  {
    Place place{};
    for (unsigned int a = 0; a < face.size(); ++a)
      {
        place.position += weights[a] * face[a].position;
        place.normal += weights[a] * face[a].normal;
      }
    double to_planes = 0.;
    for (unsigned int a = 0; a < face.size(); ++a)
      to_planes -= weights[a] * ((place.position - face[a].position) * face[a].normal);
    const double length = place.normal.norm();
    place.normal /= length;
    place.position += to_planes / (1. + length) * place.normal;
    return place;
  }
} // namespace stiction
