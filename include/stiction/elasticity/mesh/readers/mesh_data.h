#ifndef stiction_elasticity_mesh_readers_mesh_data_h
#define stiction_elasticity_mesh_readers_mesh_data_h

#include <stiction/elasticity/mesh/readers/quadratic_cells.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace stiction
{
  /// A mesh of hexahedra as a file has it, in the terms of deal.II.
  struct MeshData
  {
    std::vector<dealii::Point<3>> vertices; ///< m
    /// In the order of the file.
    std::vector<dealii::CellData<3>> cells;
    /// Quadrilaterals with a boundary id, inner ones too.
    dealii::SubCellData faces;
    /// Those of elements of second order.
    QuadraticCells::InnerNodes inner_nodes;
    std::map<std::string, unsigned int> boundary_names;
    std::map<std::string, unsigned int> material_names;

    /// How many elements there are of kinds that are no use: "tetrahedra".
    std::map<std::string, std::size_t> other_elements;
  };
} // namespace stiction

#endif
