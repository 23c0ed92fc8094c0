#include "mesh_text.h"

#include <stiction/elasticity/mesh_file.h>
#include <stiction/errors.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace stiction
{
  namespace
  {
    std::string
    extension(const std::string &file)
    {
      const std::size_t name = file.find_last_of('/');
      const std::size_t dot  = file.find_last_of('.');
      if (dot == std::string::npos || (name != std::string::npos && dot < name))
        return "";
      std::string result = file.substr(dot);
      for (char &c : result)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return result;
    }

    MeshData
    read_by_extension(const std::string &file, const std::string &location)
    {
      const std::string kind = extension(file);
      if (kind != ".msh" && kind != ".inp" && kind != ".vtk")
        throw InputError(location + ", must be a file .msh (Gmsh), .inp "
                                    "(Abaqus) or .vtk (VTK).");
      MeshText text(file, location);
      return kind == ".msh"   ? read_gmsh(text)
             : kind == ".inp" ? read_abaqus(text)
                              : read_vtk(text);
    }

    void
    require_hexahedra(const MeshData &mesh, const std::string &location)
    {
      std::string others;
      bool is_solid = !mesh.cells.empty();
      for (const auto &kind : mesh.other_elements)
        {
          others += (others.empty() ? "" : ", ") + std::to_string(kind.second) +
                    " " + kind.first;
          is_solid = is_solid || kind.first == "tetrahedra" ||
                     kind.first == "wedges" || kind.first == "pyramids";
        }
      if (!is_solid && (!others.empty() || !mesh.faces.empty()))
        throw InputError(location + ", has faces but no cells, must be a mesh "
                                    "of a solid body.");
      if (!is_solid)
        throw InputError(location + ", has no elements, must be a mesh of "
                                    "hexahedra.");
      if (!others.empty())
        throw InputError(location + ", has " + others +
                         ", must be of hexahedra alone: in Gmsh recombine "
                         "('Mesh.RecombineAll = 1' with transfinite or "
                         "extruded volumes) or subdivide "
                         "('Mesh.SubdivisionAlgorithm = 2', all hexas).");
    }

    void
    drop_unused_vertices(MeshData &mesh)
    {
      constexpr unsigned int unused = std::numeric_limits<unsigned int>::max();
      std::vector<unsigned int> index(mesh.vertices.size(), unused);
      for (const MeshData::Cell &cell : mesh.cells)
        for (const unsigned int v : cell.vertices)
          index[v] = 0;
      unsigned int n = 0;
      for (unsigned int v = 0; v < index.size(); ++v)
        if (index[v] != unused)
          {
            mesh.vertices[n] = mesh.vertices[v];
            index[v]         = n++;
          }
      mesh.vertices.resize(n);
      for (MeshData::Cell &cell : mesh.cells)
        for (unsigned int &v : cell.vertices)
          v = index[v];
      for (MeshData::Face &face : mesh.faces)
        for (unsigned int &v : face.vertices)
          v = index[v];
    }

    // "hexahedron 7 with its centre at (1, 2, 3)", counted from 1 in the order
    // of the file
    std::string
    describe_cell(const MeshData &mesh, const std::size_t number)
    {
      std::array<double, 3> centre = {{0., 0., 0.}};
      for (const unsigned int v : mesh.cells[number].vertices)
        for (unsigned int c = 0; c < 3; ++c)
          centre[c] += mesh.vertices[v][c] / 8.;
      std::ostringstream out;
      out << "hexahedron " << number + 1 << " with its centre at (" << centre[0]
          << ' ' << centre[1] << ' ' << centre[2] << ')';
      return out.str();
    }

    // Which cells have a face in common, found by its sorted vertices.
    class Faces
    {
    public:
      Faces(const MeshData &mesh, const std::string &location)
        : mesh_(mesh)
        , location_(location)
        , piece_(mesh.cells.size())
      {
        std::iota(piece_.begin(), piece_.end(), 0);
        for (std::size_t i = 0; i < mesh.cells.size(); ++i)
          add_cell(i);
      }

      void
      require_one_piece()
      {
        for (std::size_t i = 0; i < piece_.size(); ++i)
          if (piece(i) != piece(0))
            throw InputError(location_ + ", " + describe_cell(mesh_, i) +
                             " is not connected by faces with hexahedron 1, "
                             "must be one body, in which neighbours have the "
                             "same nodes.");
      }

      void
      require_boundaries_fit()
      {
        std::map<Key, unsigned int> ids;
        for (const MeshData::Face &face : mesh_.faces)
          {
            const Key key = sorted(face.vertices);
            if (cells_.count(key) == 0)
              throw InputError(location_ +
                               ", has a quadrilateral of boundary " +
                               std::to_string(face.boundary) +
                               " that is no face of a hexahedron, faces and "
                               "hexahedra must have the same nodes.");
            const auto known = ids.emplace(key, face.boundary);
            if (known.first->second != face.boundary)
              throw InputError(
                location_ + ", has a face of " +
                describe_cell(mesh_, cells_.at(key).first) +
                " on the boundaries " + std::to_string(known.first->second) +
                " and " + std::to_string(face.boundary) + ", must be on one.");
          }
      }

    private:
      using Key = std::array<unsigned int, 4>;

      static Key
      sorted(Key vertices)
      {
        std::sort(vertices.begin(), vertices.end());
        return vertices;
      }

      void
      add_cell(const std::size_t number)
      {
        auto vertices       = mesh_.cells[number].vertices;
        const auto in_order = vertices;
        std::sort(vertices.begin(), vertices.end());
        if (std::adjacent_find(vertices.begin(), vertices.end()) !=
            vertices.end())
          throw InputError(location_ + ", " + describe_cell(mesh_, number) +
                           " has a node twice, must have eight nodes.");

        static const unsigned int faces[6][4] = {{0, 1, 2, 3},
                                                 {4, 5, 6, 7},
                                                 {0, 1, 5, 4},
                                                 {1, 2, 6, 5},
                                                 {2, 3, 7, 6},
                                                 {3, 0, 4, 7}};
        for (const auto &face : faces)
          {
            const Key key      = sorted({{in_order[face[0]],
                                          in_order[face[1]],
                                          in_order[face[2]],
                                          in_order[face[3]]}});
            Neighbours &shared = cells_[key];
            if (shared.n == 0)
              shared.first = number;
            else
              join(shared.first, number);
            if (++shared.n > 2)
              throw InputError(location_ + ", " + describe_cell(mesh_, number) +
                               " shares a face with two others, at most two "
                               "hexahedra may have a face in common.");
          }
        if (!cells_by_vertices_.insert(vertices).second)
          throw InputError(location_ + ", " + describe_cell(mesh_, number) +
                           " stands twice, must stand once.");
      }

      std::size_t
      piece(std::size_t i)
      {
        while (piece_[i] != i)
          i = piece_[i] = piece_[piece_[i]];
        return i;
      }

      void
      join(const std::size_t a, const std::size_t b)
      {
        piece_[piece(b)] = piece(a);
      }

      struct Neighbours
      {
        std::size_t first = 0;
        unsigned int n    = 0;
      };

      const MeshData &mesh_;
      const std::string &location_;
      std::vector<std::size_t> piece_; // of connected cells: a cell of it
      std::map<Key, Neighbours> cells_;
      std::set<std::array<unsigned int, 8>> cells_by_vertices_;
    };
  } // namespace



  MeshData
  read_mesh_file(const std::string &file, const std::string &location)
  {
    MeshData mesh = read_by_extension(file, location);
    require_hexahedra(mesh, location);
    drop_unused_vertices(mesh);
    Faces faces(mesh, location);
    faces.require_one_piece();
    faces.require_boundaries_fit();
    return mesh;
  }
} // namespace stiction
