#pragma once

#include <stiction/elasticity/mesh/readers/mesh_data.h>

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace stiction
{
  /// The faces of a mesh, each with the cells that have it, found by its vertices. What
  /// is no body throws InputError.
  class Faces
  {
  public:
    /// @param location the beginning of a sentence about the file. Both arguments must
    ///   outlive the object.
    ///
    /// Throws if a cell has a node twice or stands twice, or three have one face.
    Faces(const MeshData &mesh, const std::string &location);

    /// A quadrilateral of one cell against two triangles of others would be a crack.
    void require_conforming() const;

    /// Cells must not meet at an edge or a vertex alone: neither has deal.II a mesh of
    /// them, nor do they make a body.
    void require_manifold() const;

    /// Neighbours must be on either side of their face.
    void require_unfolded() const;

    /// Faces of boundaries must be faces of cells. Those of several get the one that is
    /// in use, of which there must be at most one, else the first. Those inside, which
    /// are no boundary, are marked as such.
    ///
    /// @param lost what boundaries lose by that, a clause each.
    ///
    /// @return what of it boundaries in use do not have outside, a clause each, which
    ///   begins with the number of faces.
    std::vector<std::string> require_boundaries_fit(
      std::vector<dealii::CellData<2>> &boundary,
      const std::set<dealii::types::boundary_id> &in_use,
      std::vector<std::string> &lost) const;

    /// Where faces of boundaries seem to be missing: a face of none has more than half of
    /// its edges in common with faces of one that are in line with it, and the others
    /// with none in line. A sound mesh that leaves a part of a plane out has more faces
    /// there.
    ///
    /// @param boundary as require_boundaries_fit() leaves it.
    ///
    /// @return a clause for each such boundary, which begins with the number of faces.
    std::vector<std::string> holes_in(
      const std::vector<dealii::CellData<2>> &boundary) const;

  private:
    // Sorted; the last entry of a triangle is larger than any vertex.
    using Key = std::array<unsigned int, 4>;

    struct Face
    {
      Key vertices;
      std::size_t first, second; // cells, the second may be none
      unsigned int number;       // of the face in the first cell
    };

    // Of a cell, by local numbers: an edge or, twice the same, a vertex.
    using Part = std::array<unsigned int, 2>;

    static Key sorted(const std::vector<unsigned int> &vertices);

    // The face with these vertices, or null.
    const Face *find(const Key &vertices) const;

    // In deal.II's order.
    std::vector<unsigned int> vertices_of_face(std::size_t cell, unsigned int face) const;

    void require_different_nodes() const;

    // Across the face, to either side.
    dealii::Tensor<1, 3> normal_of(const Face &face) const;

    // On which side of the first cell's face a cell is.
    double side_of(std::size_t cell, const Face &face) const;

    static std::vector<Part> edges_of(const dealii::CellData<3> &cell);
    static std::vector<Part> vertices_of(const dealii::CellData<3> &cell);

    // A part of a cell by the vertices of the mesh, in order.
    Part in_mesh(std::size_t cell, const Part &part) const;

    // All cells with an edge or vertex in common must be reached from each other
    // through faces that have it, too.
    template<typename Parts>
    void require_connected_around(const Parts &parts_of, const std::string &name) const;

    const MeshData &mesh_;
    const std::string &location_;
    std::vector<Face> faces_; // in the order of their vertices
  };
} // namespace stiction
