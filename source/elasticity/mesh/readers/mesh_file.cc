#include "mesh_builder.h"
#include "product_cell.h"

#include <stiction/base/errors.h>
#include <stiction/elasticity/mesh/readers/cut_into_hexahedra.h>
#include <stiction/elasticity/mesh/readers/mesh_file.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/reference_cell.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <set>
#include <sstream>
#include <unordered_map>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    MeshData read_by_extension(const std::string &file, const std::string &location)
    {
      const std::string kind = upper(std::filesystem::path(file).extension());
      if (kind != ".MSH" && kind != ".INP" && kind != ".VTK")
        throw InputError(location + ", must be a file .msh (Gmsh), .inp "
                                    "(Abaqus) or .vtk (VTK).");
      TextScanner text(file, location);
      if (!text.is_readable())
        throw InputError(location + ", cannot be read, must be the path of a mesh file.");
      if (text.is_empty())
        throw InputError(location + ", is empty, must be a mesh file.");
      return kind == ".MSH"   ? read_gmsh(text)
             : kind == ".INP" ? read_abaqus(text)
                              : read_vtk(text);
    }

    // where it has no names
    std::string how_to_name_boundaries(const MeshData &mesh, const std::string &file)
    {
      const std::string kind = upper(std::filesystem::path(file).extension());
      const std::string way =
        kind == ".MSH"   ? "write 'Physical Surface(\"bottom\") = {...};' for each "
                           "and a 'Physical Volume' for the body before Gmsh meshes it"
        : kind == ".INP" ? "write a '*SURFACE, NAME=bottom' for each, with elements, or "
                           "sets of them, and their faces S1, S2, ..."
                         : "write triangles or quadrilaterals of each with a number of "
                           "its own in the cell data 'MaterialID', which is what to "
                           "call it";
      const std::string lacking = mesh.faces.boundary_quads.empty()
                                    ? "the file has no surface elements, so all of its "
                                      "surface is the boundary 0; "
                                    : "its boundaries have no names; ";
      return lacking + way;
    }

    void require_cells(const MeshData &mesh, const std::string &location)
    {
      std::string others;
      bool is_solid = !mesh.cells.empty();
      for (const auto &kind : mesh.other_elements)
        {
          others +=
            (others.empty() ? "" : ", ") + std::to_string(kind.second) + " " + kind.first;
          is_solid = is_solid || kind.first == "pyramids";
        }
      if (!is_solid && (!others.empty() || !mesh.faces.boundary_quads.empty()))
        throw InputError(location + ", has faces but no cells, must be a mesh "
                                    "of a solid body.");
      if (!is_solid)
        throw InputError(location + ", has no elements, must be a mesh of "
                                    "tetrahedra, prisms or hexahedra.");
      if (!others.empty())
        throw InputError(
          location + ", has " + others +
          ", must be of tetrahedra, prisms and hexahedra alone" +
          (others.find("of type") == std::string::npos
             ? std::string(": mesh "
                           "the body with tetrahedra, or extrude all of it; pyramids "
                           "stand where quadrilaterals of recombined or transfinite "
                           "surfaces meet tetrahedra.")
             : std::string(": leave the others out; boundaries of a .inp "
                           "are no elements but '*SURFACE, NAME=bottom' with cells "
                           "and their faces S1, S2, ....")));
    }

    Point<3> centre_of(const MeshData &mesh, const std::size_t cell)
    {
      const auto &vertices = mesh.cells[cell].vertices;
      Point<3> centre;
      for (const unsigned int v : vertices)
        centre += mesh.vertices[v] / static_cast<double>(vertices.size());
      return centre;
    }

    // "hexahedron 7 with its centre at (1, 2, 3)", cells being counted from 1 in
    // the order of the file
    std::string describe_cell(const MeshData &mesh, const std::size_t number)
    {
      std::ostringstream out;
      out << kind_of_cell(mesh.cells[number].vertices.size()) << ' ' << number + 1
          << " with its centre at (" << centre_of(mesh, number) << ')';
      return out.str();
    }

    // Which cells have a face in common, found by its sorted vertices.
    class Faces
    {
    public:
      Faces(MeshData &mesh, const std::string &location)
        : mesh_(mesh)
        , location_(location)
        , pieces_(mesh.cells.size())
      {
        for (std::size_t i = 0; i < mesh.cells.size(); ++i)
          add_cell(i);
      }

      void require_one_piece()
      {
        std::set<std::size_t> seen;
        std::vector<std::size_t> first_cells;
        for (std::size_t i = 0; i < mesh_.cells.size(); ++i)
          if (seen.insert(pieces_.find_set(i)).second)
            first_cells.push_back(i);
        if (first_cells.size() < 2)
          return;
        throw InputError(
          location_ + ", is in " + std::to_string(first_cells.size()) +
          " pieces: " + describe_cell(mesh_, first_cells[1]) +
          " is not connected by faces with " + describe_cell(mesh_, first_cells[0]) +
          ", must be one body, in which neighbours have the same nodes: leave all but "
          "one of the bodies out, or, where the pieces touch, merge nodes at the same "
          "place (Gmsh: 'Coherence Mesh').");
      }

      // Neighbours are on either side of their face.
      void require_unfolded()
      {
        for (const auto &[vertices, cells] : cells_)
          if (cells.n == 2 && cells.side * side_of(cells.second, cells.plane) > 0.)
            throw InputError(location_ + ", " + describe_cell(mesh_, cells.first) +
                             " and " + describe_cell(mesh_, cells.second) +
                             " lie on the same side of the face that they share, must "
                             "lie on either side: the mesh is folded into itself there, "
                             "put the node that is on the wrong side in its place or "
                             "mesh the body anew.");
      }

      // Cells that meet at an edge or a vertex alone: neither has deal.II a
      // mesh of them, nor do they make a body.
      void require_manifold()
      {
        require_connected_around(edges_of, "edge");
        require_connected_around(vertices_of, "node");
      }

      // A quadrilateral of one cell against two triangles of others would be a
      // crack.
      void require_conforming()
      {
        std::map<Key, std::size_t> triangles;
        for (const auto &[vertices, cells] : cells_)
          if (vertices.size() == 3 && cells.n == 1)
            triangles.emplace(vertices, cells.first);
        for (const auto &[vertices, cells] : cells_)
          for (unsigned int v = 0; vertices.size() == 4 && cells.n == 1 && v < 4; ++v)
            {
              Key three = vertices;
              three.erase(three.begin() + v);
              const auto other = triangles.find(three);
              if (other != triangles.end())
                throw InputError(location_ + ", a quadrilateral of " +
                                 describe_cell(mesh_, cells.first) +
                                 " lies against a triangle of " +
                                 describe_cell(mesh_, other->second) +
                                 ", must lie against a quadrilateral: mesh the body "
                                 "with tetrahedra, or extrude all of it.");
            }
      }

      // and marks what is inside, which is no boundary
      void require_boundaries_fit()
      {
        std::map<Key, unsigned int> ids;
        for (CellData<2> &face : mesh_.faces.boundary_quads)
          {
            const Key key = sorted(face.vertices);
            if (cells_.count(key) == 0)
              throw InputError(
                location_ + ", has a " +
                (key.size() == 3 ? "triangle" : "quadrilateral") + " of boundary " +
                std::to_string(face.boundary_id) +
                " that is no face of a cell, faces and cells must have the same nodes.");
            const auto known = ids.emplace(key, face.boundary_id);
            if (known.first->second != face.boundary_id)
              throw InputError(location_ + ", has a face of " +
                               describe_cell(mesh_, cells_.at(key).first) +
                               " on the boundaries " +
                               std::to_string(known.first->second) + " and " +
                               std::to_string(face.boundary_id) + ", must be on one.");
            if (cells_.at(key).n == 2)
              face.boundary_id = numbers::internal_face_boundary_id;
          }
      }

    private:
      using Key = std::vector<unsigned int>; // sorted

      static Key sorted(Key vertices)
      {
        std::sort(vertices.begin(), vertices.end());
        return vertices;
      }

      using Part = std::array<unsigned int, 2>; // local: an edge or, twice
                                                // the same, a vertex

      static std::vector<Part> edges_of(const CellData<3> &cell)
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

      static std::vector<Part> vertices_of(const CellData<3> &cell)
      {
        std::vector<Part> vertices;
        for (unsigned int v = 0; v < cell.vertices.size(); ++v)
          vertices.push_back({{v, v}});
        return vertices;
      }

      std::uint64_t key(const std::size_t cell, const Part &part) const
      {
        const auto &of_cell = mesh_.cells[cell].vertices;
        const auto ends     = std::minmax(of_cell[part[0]], of_cell[part[1]]);
        return (static_cast<std::uint64_t>(ends.first) << 32) | ends.second;
      }

      // All cells with an edge or vertex in common must be reached from each
      // other through faces that have it, too.
      template<typename Parts>
      void require_connected_around(const Parts &parts_of, const std::string &name)
      {
        std::map<std::size_t, std::vector<Part>> parts; // by numbers of vertices
        for (const unsigned int n_vertices : {4, 6, 8})
          parts[n_vertices] = parts_of(CellData<3>(n_vertices));
        const auto parts_in = [&](const std::size_t cell) -> const std::vector<Part> & {
          return parts.at(mesh_.cells[cell].vertices.size());
        };
        const std::size_t n = parts[8].size(); // the most
        boost::disjoint_sets_with_storage<> around(n * mesh_.cells.size());
        for (const auto &[vertices, cells] : cells_)
          if (cells.n == 2)
            for (std::size_t p = 0; p < parts_in(cells.first).size(); ++p)
              {
                const std::uint64_t common = key(cells.first, parts_in(cells.first)[p]);
                for (std::size_t q = 0; q < parts_in(cells.second).size(); ++q)
                  if (key(cells.second, parts_in(cells.second)[q]) == common &&
                      is_in(vertices, common))
                    around.union_set(n * cells.first + p, n * cells.second + q);
              }
        std::unordered_map<std::uint64_t, std::size_t> first;
        for (std::size_t cell = 0; cell < mesh_.cells.size(); ++cell)
          for (std::size_t p = 0; p < parts_in(cell).size(); ++p)
            {
              const std::size_t i = n * cell + p;
              const std::size_t other =
                first.emplace(key(cell, parts_in(cell)[p]), i).first->second;
              if (around.find_set(i) != around.find_set(other))
                throw InputError(location_ + ", " + describe_cell(mesh_, other / n) +
                                 " and " + describe_cell(mesh_, cell) +
                                 " meet at a single " + name +
                                 ", cells that touch must be connected by faces around "
                                 "it.");
            }
      }

      static bool is_in(const Key &face, const std::uint64_t part)
      {
        return std::binary_search(face.begin(), face.end(), part >> 32) &&
               std::binary_search(face.begin(), face.end(), part & 0xffffffff);
      }

      void add_cell(const std::size_t number)
      {
        const auto &in_order = mesh_.cells[number].vertices;
        const Key vertices   = sorted(in_order);
        if (std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end())
          throw InputError(location_ + ", " + describe_cell(mesh_, number) +
                           " has a node twice, its nodes must differ.");

        const auto kind = ReferenceCell::n_vertices_to_type(3, vertices.size());
        for (const unsigned int f : kind.face_indices())
          {
            Key key;
            for (const unsigned int v : kind.face_reference_cell(f).vertex_indices())
              key.push_back(in_order[kind.face_to_cell_vertices(f, v, 1)]);
            const Plane plane  = plane_of(key);
            key                = sorted(key);
            Neighbours &shared = cells_[key];
            if (shared.n == 0)
              {
                shared.first = number;
                shared.plane = plane;
                shared.side  = side_of(number, plane);
              }
            else
              {
                shared.second = number;
                pieces_.union_set(shared.first, number);
              }
            if (++shared.n > 2)
              throw InputError(location_ + ", " + describe_cell(mesh_, number) +
                               " shares a face with two others, at most two "
                               "cells may have a face in common.");
          }
        if (!cells_by_vertices_.insert(vertices).second)
          throw InputError(location_ + ", " + describe_cell(mesh_, number) +
                           " stands twice, must stand once.");
      }

      // A plane.
      struct Plane
      {
        Point<3> centre;
        Tensor<1, 3> normal; // towards either side
      };

      // @param vertices in deal.II's order
      Plane plane_of(const Key &vertices) const
      {
        const auto &at = mesh_.vertices;
        Plane plane;
        for (const unsigned int v : vertices)
          plane.centre += at[v] / static_cast<double>(vertices.size());
        plane.normal = vertices.size() == 3
                         ? cross_product_3d(at[vertices[1]] - at[vertices[0]],
                                            at[vertices[2]] - at[vertices[0]])
                         : cross_product_3d(at[vertices[3]] - at[vertices[0]],
                                            at[vertices[2]] - at[vertices[1]]);
        return plane;
      }

      double side_of(const std::size_t cell, const Plane &plane) const
      {
        return (centre_of(mesh_, cell) - plane.centre) * plane.normal;
      }

      struct Neighbours
      {
        std::size_t first = 0, second = 0;
        unsigned int n = 0;
        Plane plane;      // of the face as the first cell has it
        double side = 0.; // of the plane, on which the first cell is
      };

      MeshData &mesh_;
      const std::string &location_;
      boost::disjoint_sets_with_storage<> pieces_; // of connected cells
      std::map<Key, Neighbours> cells_;
      std::set<Key> cells_by_vertices_;
    };
  } // namespace

  MeshData read_mesh_file(const std::string &file, const std::string &location)
  {
    MeshData mesh = read_by_extension(file, location);
    require_cells(mesh, location);
    mesh.how_to_name_boundaries = how_to_name_boundaries(mesh, file);
    {
      Faces faces(mesh, location);
      faces.require_conforming();
      faces.require_one_piece();
      faces.require_manifold();
      faces.require_unfolded();
      faces.require_boundaries_fit();
    }
    cut_into_hexahedra(mesh);
    GridTools::consistently_order_cells(mesh.cells);
    return mesh;
  }
} // namespace stiction
