#include "product_cell.h"

#include <stiction/elasticity/mesh/readers/cut_into_hexahedra.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
    using Vertices    = ProductCell::Vertices;
    using Coordinates = ProductCell::Coordinates;

    // What is cut off at a vertex of a factor, the image of a segment, a square or a
    // cube: its corners are in the middle of the vertices that are bits of a number.
    struct PartOfElement
    {
      unsigned int vertex;
      std::vector<unsigned int> corners;
    };

    std::vector<PartOfElement> pieces(const unsigned int n_vertices)
    {
      std::vector<PartOfElement> pieces;
      for (unsigned int v = 0; v < n_vertices; ++v)
        {
          pieces.push_back({v, {1U << v}});
          for (unsigned int w = 0; w < n_vertices; ++w)
            if (w != v)
              {
                auto &corners       = pieces.back().corners;
                const std::size_t n = corners.size();
                for (std::size_t i = 0; i < n; ++i)
                  corners.push_back(corners[i] | 1U << w);
              }
        }
      return pieces;
    }

    // The nodes that all cells of second order have, in their middle and in that of
    // their edges and faces: which of the eight vertices these are.
    std::vector<Vertices> inner_parts_of_cube()
    {
      const ProductCell cube({2, 2, 2}, {0, 1, 2, 3, 4, 5, 6, 7});
      std::vector<Vertices> parts;
      for (const auto &part : cube.parts(2))
        parts.push_back(cube.vertices_of(part));
      parts.erase(parts.begin(), parts.begin() + 8); // the vertices
      return parts;
    }

    class Cut
    {
    public:
      explicit Cut(MeshData &mesh)
        : mesh_(mesh)
      {
        find_edges();
      }

      void run()
      {
        std::vector<dealii::CellData<3>> elements;
        elements.swap(mesh_.cells);
        std::vector<std::size_t> body_of_element;
        body_of_element.swap(mesh_.body_of_cell);
        for (const auto &element : elements)
          {
            const std::size_t n = element.vertices.size();
            ++mesh_.cut_elements[n == 4 ? "tetrahedra" : n == 6 ? "prisms" : "hexahedra"];
            cut(element);
            if (!body_of_element.empty())
              mesh_.body_of_cell.resize(mesh_.cells.size(),
                                        body_of_element[&element - elements.data()]);
          }
        std::vector<dealii::CellData<2>> faces;
        faces.swap(mesh_.faces.boundary_quads);
        for (const auto &face : faces)
          cut(face);
        mesh_.inner_nodes.swap(inner_nodes_);
      }

    private:
      // Edges along segments that are halved or left as they are together. The edges
      // of triangles are all halved.
      void find_edges()
      {
        std::vector<ProductCell> cells(mesh_.cells.begin(), mesh_.cells.end());
        for (const ProductCell &cell : cells)
          for (unsigned int f = 0; f < cell.factors().size(); ++f)
            if (cell.factors()[f] == 2)
              for (const Vertices &edge : cell.edges_along(f))
                edges_.emplace(edge, edges_.size() + 1);
        together_ = boost::disjoint_sets_with_storage<>(edges_.size() + 1);
        for (const ProductCell &cell : cells)
          for (unsigned int f = 0; f < cell.factors().size(); ++f)
            {
              if (edges_.empty())
                return;
              const auto edges = cell.edges_along(f);
              for (const Vertices &edge : edges)
                if (edges_.count(edge) == 1)
                  together_.union_set(cell.factors()[f] == 2 ? edges_.at(edges[0]) : 0,
                                      edges_.at(edge));
            }
      }

      bool is_halved(const ProductCell &cell, const unsigned int factor)
      {
        if (cell.factors()[factor] > 2)
          return true;
        const auto edge = edges_.find(cell.edges_along(factor)[0]);
        return edge == edges_.end() ||
               together_.find_set(edge->second) == together_.find_set(std::size_t(0));
      }

      // All choices of a piece of each factor.
      std::vector<std::vector<PartOfElement>> pieces_of(const ProductCell &cell)
      {
        std::vector<std::vector<PartOfElement>> of_factors;
        for (unsigned int f = 0; f < cell.factors().size(); ++f)
          of_factors.push_back(is_halved(cell, f)
                                 ? pieces(cell.factors()[f])
                                 : std::vector<PartOfElement>{{0, {1, 2}}});
        return product(of_factors);
      }

      static std::vector<ProductCell::Part> corners_of(
        const std::vector<PartOfElement> &piece)
      {
        std::vector<std::vector<unsigned int>> corners;
        for (const PartOfElement &of_factor : piece)
          corners.push_back(of_factor.corners);
        return product(corners);
      }

      void cut(const dealii::CellData<3> &element)
      {
        ProductCell cell(element);
        cell.find_nodes(mesh_);
        for (const std::vector<PartOfElement> &piece : pieces_of(cell))
          {
            std::vector<Coordinates> corners;
            mesh_.cells.push_back(element);
            Vertices &vertices = mesh_.cells.back().vertices;
            vertices.clear();
            for (const auto &corner : corners_of(piece))
              {
                corners.push_back(cell.middle_of(corner));
                vertices.push_back(node(cell.vertices_of(corner), cell, corners.back()));
              }
            if (cell.is_curved())
              add_inner_nodes(cell, corners, vertices);
            // The other vertices of a factor are in ascending order seen from a
            // vertex with an even number, that is positive, and not from the others.
            // All edges go from vertices to middles, whichever of them is first.
            unsigned int sign = 0;
            for (const PartOfElement &of_factor : piece)
              sign += of_factor.vertex;
            if (sign % 2 == 1)
              {
                std::swap(vertices[1], vertices[2]);
                std::swap(vertices[5], vertices[6]);
              }
          }
      }

      void cut(const dealii::CellData<2> &element)
      {
        const ProductCell face(element);
        for (const std::vector<PartOfElement> &piece : pieces_of(face))
          {
            mesh_.faces.boundary_quads.push_back(element);
            Vertices &vertices = mesh_.faces.boundary_quads.back().vertices;
            vertices.clear();
            for (const auto &corner : corners_of(piece))
              {
                const Vertices around = face.vertices_of(corner);
                vertices.push_back(around.size() == 1 ? around[0] : nodes_.at(around));
              }
            std::swap(vertices[2], vertices[3]); // which go around
          }
      }

      // The vertex that is a vertex of the element or in the middle of several.
      unsigned int node(const Vertices &around, const ProductCell &cell,
                        const Coordinates &point)
      {
        if (around.size() == 1)
          return around[0];
        const auto known = nodes_.emplace(around, mesh_.vertices.size());
        if (known.second)
          mesh_.vertices.push_back(cell.position(point));
        return known.first->second;
      }

      void add_inner_nodes(const ProductCell &cell,
                           const std::vector<Coordinates> &corners,
                           const Vertices &vertices)
      {
        static const std::vector<Vertices> parts = inner_parts_of_cube();
        for (const Vertices &part : parts)
          {
            Vertices key;
            Coordinates point = corners[part[0]];
            for (std::size_t f = 0; f < point.size(); ++f)
              for (std::size_t i = 0; i < point[f].size(); ++i)
                {
                  point[f][i] = 0.;
                  for (const unsigned int v : part)
                    point[f][i] += corners[v][f][i] / static_cast<double>(part.size());
                }
            for (const unsigned int v : part)
              key.push_back(vertices[v]);
            std::sort(key.begin(), key.end());
            if (inner_nodes_.count(key) == 0)
              inner_nodes_.emplace(key, cell.position(point));
          }
      }

      MeshData &mesh_;
      std::map<Vertices, std::size_t> edges_;        // along segments, from 1
      boost::disjoint_sets_with_storage<> together_; // 0: those of triangles
      std::map<Vertices, unsigned int>
        nodes_; // by the vertices they are in the middle of
      QuadraticCells::InnerNodes inner_nodes_;
    };
  } // namespace

  void cut_into_hexahedra(MeshData &mesh)
  {
    if (std::any_of(mesh.cells.begin(), mesh.cells.end(),
                    [](const auto &cell) { return cell.vertices.size() < 8; }))
      Cut(mesh).run();
  }
} // namespace stiction
