#ifndef stiction_elasticity_mesh_data_h
#define stiction_elasticity_mesh_data_h

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace stiction
{
  /// A mesh of hexahedra as a file has it.
  struct MeshData
  {
    /// Vertices go around the bottom, then around the top in the same sense,
    /// as in Gmsh, Abaqus and VTK.
    struct Cell
    {
      std::array<unsigned int, 8> vertices;
      unsigned int material;
    };

    /// A face with a boundary id, vertices in turn.
    struct Face
    {
      std::array<unsigned int, 4> vertices;
      unsigned int boundary;
    };

    std::vector<std::array<double, 3>> vertices; ///< m
    std::vector<Cell> cells;
    std::vector<Face> faces; ///< those that have an id, inner ones too
    std::map<std::string, unsigned int> boundary_names;
    std::map<std::string, unsigned int> material_names;

    /// How many elements there are of kinds that are no use: "tetrahedra".
    std::map<std::string, std::size_t> other_elements;
  };
} // namespace stiction

#endif
