#include "faces.h"

#include "mesh_builder.h"
#include "product_cell.h"

#include <stiction/base/errors.h>
#include <stiction/base/text/in_words.h>

#include <deal.II/grid/reference_cell.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int no_vertex = std::numeric_limits<unsigned int>::max();
    constexpr std::size_t no_cell    = std::numeric_limits<std::size_t>::max();

    // Of the angle between normals of faces that are in line, 10 degrees.
    constexpr double cosine_in_line = 0.985;

    Point<3> centre_of(const MeshData &mesh, const std::vector<unsigned int> &vertices)
    {
      Point<3> centre;
      for (const unsigned int v : vertices)
        centre += mesh.vertices[v] / static_cast<double>(vertices.size());
      return centre;
    }

    // "hexahedron 7 with its centre at (1, 2, 3)", cells being counted from 1 in
    // the order of the file
    std::string describe_cell(const MeshData &mesh, const std::size_t number)
    {
      const auto &vertices = mesh.cells[number].vertices;
      return text_of(kind_of_cell(vertices.size()), ' ', number + 1,
                     " with its centre at (", centre_of(mesh, vertices), ')');
    }
  } // namespace

  Faces::Faces(const MeshData &mesh, const std::string &location)
    : mesh_(mesh)
    , location_(location)
  {
    require_different_nodes();
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (const unsigned int f :
           ReferenceCell::n_vertices_to_type(3, mesh.cells[cell].vertices.size())
             .face_indices())
        faces_.push_back({sorted(vertices_of_face(cell, f)), cell, no_cell, f});
    std::sort(faces_.begin(), faces_.end(), [](const Face &a, const Face &b) {
      return std::tie(a.vertices, a.first) < std::tie(b.vertices, b.first);
    });
    // those of two cells stand beside each other
    std::size_t n = 0;
    for (const Face &face : faces_)
      if (n == 0 || faces_[n - 1].vertices != face.vertices)
        faces_[n++] = face;
      else if (faces_[n - 1].second == no_cell)
        faces_[n - 1].second = face.first;
      else
        throw InputError(location_ + ", " + describe_cell(mesh_, face.first) +
                         " shares a face with two others, at most two "
                         "cells may have a face in common.");
    faces_.resize(n);
  }

  void Faces::require_different_nodes() const
  {
    std::vector<std::pair<std::vector<unsigned int>, std::size_t>> cells;
    for (std::size_t cell = 0; cell < mesh_.cells.size(); ++cell)
      {
        auto vertices = mesh_.cells[cell].vertices;
        std::sort(vertices.begin(), vertices.end());
        if (std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end())
          throw InputError(location_ + ", " + describe_cell(mesh_, cell) +
                           " has a node twice, its nodes must differ.");
        cells.emplace_back(std::move(vertices), cell);
      }
    std::sort(cells.begin(), cells.end());
    for (std::size_t i = 1; i < cells.size(); ++i)
      if (cells[i].first == cells[i - 1].first)
        throw InputError(location_ + ", " + describe_cell(mesh_, cells[i].second) +
                         " stands twice, must stand once.");
  }

  void Faces::require_unfolded() const
  {
    for (const Face &face : faces_)
      if (face.second != no_cell &&
          side_of(face.first, face) * side_of(face.second, face) > 0.)
        throw InputError(location_ + ", " + describe_cell(mesh_, face.first) + " and " +
                         describe_cell(mesh_, face.second) +
                         " lie on the same side of the face that they share, must "
                         "lie on either side: the mesh is folded into itself there, "
                         "put the node that is on the wrong side in its place or "
                         "mesh the body anew.");
  }

  void Faces::require_manifold() const
  {
    require_connected_around(edges_of, "edge");
    require_connected_around(vertices_of, "node");
  }

  void Faces::require_conforming() const
  {
    for (const Face &face : faces_)
      for (unsigned int v = 0;
           face.vertices[3] != no_vertex && face.second == no_cell && v < 4; ++v)
        {
          Key three = face.vertices;
          std::copy(three.begin() + v + 1, three.end(), three.begin() + v);
          three[3]          = no_vertex;
          const Face *other = find(three);
          if (other != nullptr && other->second == no_cell)
            throw InputError(
              location_ + ", a quadrilateral of " + describe_cell(mesh_, face.first) +
              " lies against a triangle of " + describe_cell(mesh_, other->first) +
              ", must lie against a quadrilateral: mesh the body "
              "with tetrahedra, or extrude all of it.");
        }
  }

  std::vector<std::string> Faces::require_boundaries_fit(
    std::vector<CellData<2>> &boundary, const std::set<types::boundary_id> &in_use,
    std::vector<std::string> &lost) const
  {
    std::map<Key, types::boundary_id> ids;
    for (const CellData<2> &quad : boundary)
      {
        const Key key    = sorted(quad.vertices);
        const Face *face = find(key);
        if (face == nullptr)
          throw InputError(
            location_ + ", has a " +
            (quad.vertices.size() == 3 ? "triangle" : "quadrilateral") + " of boundary " +
            mesh_.name_of_boundary(quad.boundary_id) +
            " that is no face of a cell, faces and cells must have the same nodes.");
        types::boundary_id &id = ids.emplace(key, quad.boundary_id).first->second;
        if (id == quad.boundary_id || in_use.count(quad.boundary_id) == 0)
          continue;
        if (in_use.count(id) > 0 && face->second == no_cell)
          throw InputError(location_ + ", has a face of " +
                           describe_cell(mesh_, face->first) + " on the boundaries " +
                           mesh_.name_of_boundary(id) + " and " +
                           mesh_.name_of_boundary(quad.boundary_id) +
                           ", must be on one of those that the parameter file uses.");
        id = quad.boundary_id;
      }

    using Pair = std::pair<types::boundary_id, types::boundary_id>;
    std::map<Pair, std::set<Key>> on_another;
    std::map<types::boundary_id, std::set<Key>> inside;
    std::set<types::boundary_id> outside;
    std::map<Key, CellData<2>> once;
    for (CellData<2> &quad : boundary)
      {
        const Key key  = sorted(quad.vertices);
        const auto own = std::exchange(quad.boundary_id, ids.at(key));
        if (find(key)->second != no_cell)
          {
            inside[own].insert(key);
            quad.boundary_id = numbers::internal_face_boundary_id;
          }
        else
          {
            outside.insert(own);
            if (quad.boundary_id != own)
              on_another[{own, quad.boundary_id}].insert(key);
          }
        once.emplace(key, quad);
      }
    boundary.clear();
    for (const auto &[key, quad] : once)
      boundary.push_back(quad);

    std::vector<std::string> damages;
    const auto count = [&](const std::set<Key> &faces, const types::boundary_id id) {
      return std::to_string(faces.size()) + (faces.size() == 1 ? " face" : " faces") +
             " of boundary " + mesh_.name_of_boundary(id);
    };
    for (const auto &[id, faces] : inside)
      if (outside.count(id) > 0 && in_use.count(id) == 0)
        lost.push_back(count(faces, id) + " inside of the body");
      else if (outside.count(id) > 0)
        damages.push_back(count(faces, id) +
                          " inside of the body, between two cells: "
                          "no contact, load or support acts there; parts of a body that "
                          "are to be two need nodes of their own");
    for (const auto &[pair, faces] : on_another)
      lost.push_back(count(faces, pair.first) + " that " +
                     (faces.size() == 1 ? "is" : "are") + " on boundary " +
                     mesh_.name_of_boundary(pair.second) + " as well");
    return damages;
  }

  std::vector<std::string> Faces::holes_in(const std::vector<CellData<2>> &boundary) const
  {
    std::map<Key, types::boundary_id> ids;
    for (const CellData<2> &quad : boundary)
      ids.emplace(sorted(quad.vertices), quad.boundary_id);

    struct Outer
    {
      std::vector<unsigned int> around;
      Tensor<1, 3> normal;
      types::boundary_id id; // 0: of none
    };
    std::vector<Outer> outer;
    std::map<Part, std::vector<std::size_t>> at_edge; // places in these
    const auto edge = [](const std::vector<unsigned int> &around, const std::size_t e) {
      const auto [low, high] = std::minmax(around[e], around[(e + 1) % around.size()]);
      return Part{{low, high}};
    };
    for (const Face &face : faces_)
      if (face.second == no_cell)
        {
          auto around = vertices_of_face(face.first, face.number);
          if (around.size() == 4)
            std::swap(around[2], around[3]);
          for (std::size_t e = 0; e < around.size(); ++e)
            at_edge[edge(around, e)].push_back(outer.size());
          const Tensor<1, 3> normal = normal_of(face) / normal_of(face).norm();
          const auto id             = ids.find(face.vertices);
          outer.push_back({around, side_of(face.first, face) < 0. ? normal : -normal,
                           id == ids.end() ? 0 : id->second});
        }

    std::map<types::boundary_id, std::size_t> missing;
    std::map<types::boundary_id, Point<3>> places;
    for (const Outer &face : outer)
      {
        if (face.id != 0)
          continue;
        std::map<types::boundary_id, std::size_t> n_edges; // with faces in line
        for (std::size_t e = 0; e < face.around.size(); ++e)
          for (const std::size_t other : at_edge[edge(face.around, e)])
            if (&outer[other] != &face &&
                outer[other].normal * face.normal > cosine_in_line)
              ++n_edges[outer[other].id];
        for (const auto &[id, n] : n_edges)
          if (id != 0 && 2 * n > face.around.size())
            {
              ++missing[id];
              if (n_edges.size() == 1)
                places.emplace(id, centre_of(mesh_, face.around));
            }
      }
    std::vector<std::string> holes;
    for (const auto &[id, place] : places)
      {
        const std::string name = mesh_.name_of_boundary(id);
        const bool is_one      = missing[id] == 1;
        holes.push_back(text_of(
          missing[id], is_one ? " face" : " faces", " in the midst of boundary ", name,
          is_one ? ", at (" : ", such as that at (", place, is_one ? "), is" : "), are",
          " of no boundary: no contact, load or support of ", name,
          " acts there; if the file has lost them, write it anew with all faces of ",
          name));
      }
    return holes;
  }

  Faces::Key Faces::sorted(const std::vector<unsigned int> &vertices)
  {
    Key key;
    key.fill(no_vertex);
    std::copy(vertices.begin(), vertices.end(), key.begin());
    std::sort(key.begin(), key.end());
    return key;
  }

  std::vector<unsigned int> Faces::vertices_of_face(const std::size_t cell,
                                                    const unsigned int face) const
  {
    const auto &in_order = mesh_.cells[cell].vertices;
    const auto kind      = ReferenceCell::n_vertices_to_type(3, in_order.size());
    std::vector<unsigned int> vertices;
    for (const unsigned int v : kind.face_reference_cell(face).vertex_indices())
      vertices.push_back(in_order[kind.face_to_cell_vertices(face, v, 1)]);
    return vertices;
  }

  const Faces::Face *Faces::find(const Key &vertices) const
  {
    const auto face = std::lower_bound(
      faces_.begin(), faces_.end(), vertices,
      [](const Face &a, const Key &of_other) { return a.vertices < of_other; });
    return face != faces_.end() && face->vertices == vertices ? &*face : nullptr;
  }

  Tensor<1, 3> Faces::normal_of(const Face &face) const
  {
    const auto &at      = mesh_.vertices;
    const auto vertices = vertices_of_face(face.first, face.number);
    return vertices.size() == 3 ? cross_product_3d(at[vertices[1]] - at[vertices[0]],
                                                   at[vertices[2]] - at[vertices[0]])
                                : cross_product_3d(at[vertices[3]] - at[vertices[0]],
                                                   at[vertices[2]] - at[vertices[1]]);
  }

  double Faces::side_of(const std::size_t cell, const Face &face) const
  {
    return (centre_of(mesh_, mesh_.cells[cell].vertices) -
            centre_of(mesh_, vertices_of_face(face.first, face.number))) *
           normal_of(face);
  }

  std::vector<Faces::Part> Faces::edges_of(const CellData<3> &cell)
  {
    CellData<3> local = cell;
    for (unsigned int v = 0; v < cell.vertices.size(); ++v)
      local.vertices[v] = v;
    const ProductCell product(local);
    std::vector<Part> edges;
    for (unsigned int f = 0; f < product.factors().size(); ++f)
      for (const auto &edge : product.edges_along(f))
        edges.push_back({{edge[0], edge[1]}});
    return edges;
  }

  std::vector<Faces::Part> Faces::vertices_of(const CellData<3> &cell)
  {
    std::vector<Part> vertices;
    for (unsigned int v = 0; v < cell.vertices.size(); ++v)
      vertices.push_back({{v, v}});
    return vertices;
  }

  Faces::Part Faces::in_mesh(const std::size_t cell, const Part &part) const
  {
    const auto &of_cell    = mesh_.cells[cell].vertices;
    const auto [low, high] = std::minmax(of_cell[part[0]], of_cell[part[1]]);
    return {{low, high}};
  }

  template<typename Parts>
  void Faces::require_connected_around(const Parts &parts_of,
                                       const std::string &name) const
  {
    std::array<std::vector<Part>, 9> parts; // by numbers of vertices
    for (const unsigned int n_vertices : {4, 6, 8})
      parts[n_vertices] = parts_of(CellData<3>(n_vertices));
    const auto parts_in = [&](const std::size_t cell) -> const std::vector<Part> & {
      return parts.at(mesh_.cells[cell].vertices.size());
    };
    const std::size_t n = parts[8].size(); // the most
    boost::disjoint_sets_with_storage<> around(n * mesh_.cells.size());
    for (const Face &face : faces_)
      for (std::size_t p = 0; face.second != no_cell && p < parts_in(face.first).size();
           ++p)
        {
          const Part common = in_mesh(face.first, parts_in(face.first)[p]);
          if (!std::includes(face.vertices.begin(), face.vertices.end(), common.begin(),
                             common.begin() + (common[0] == common[1] ? 1 : 2)))
            continue;
          for (std::size_t q = 0; q < parts_in(face.second).size(); ++q)
            if (in_mesh(face.second, parts_in(face.second)[q]) == common)
              around.union_set(n * face.first + p, n * face.second + q);
        }
    std::unordered_map<std::uint64_t, std::size_t> first;
    first.reserve(4 * mesh_.cells.size());
    for (std::size_t cell = 0; cell < mesh_.cells.size(); ++cell)
      for (std::size_t p = 0; p < parts_in(cell).size(); ++p)
        {
          const auto [low, high]  = in_mesh(cell, parts_in(cell)[p]);
          const std::uint64_t key = (static_cast<std::uint64_t>(low) << 32) | high;
          const std::size_t i     = n * cell + p;
          const std::size_t other = first.emplace(key, i).first->second;
          if (around.find_set(i) != around.find_set(other))
            throw InputError(location_ + ", " + describe_cell(mesh_, other / n) +
                             " and " + describe_cell(mesh_, cell) + " meet at a single " +
                             name +
                             ", cells that touch must be connected by faces around it "
                             "(is one of them twisted, do they cut a face otherwise?); "
                             "bodies that meet there alone need nodes of their own, or a "
                             "file each in sections 'Body NAME'.");
        }
  }
} // namespace stiction
