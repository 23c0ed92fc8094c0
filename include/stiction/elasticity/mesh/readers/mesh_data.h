#pragma once

#include <stiction/elasticity/mesh/readers/quadratic_cells.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace stiction
{
  /// A mesh as a file has it, in the terms of deal.II: tetrahedra, prisms and
  /// hexahedra, told apart by how many vertices they have.
  struct MeshData
  {
    std::vector<dealii::Point<3>> vertices; ///< m
    /// In the order of the file.
    std::vector<dealii::CellData<3>> cells;
    /// Triangles and quadrilaterals with a boundary id, inner ones too, with
    /// vertices that go around.
    dealii::SubCellData faces;
    /// Those of elements of second order.
    QuadraticCells::InnerNodes inner_nodes;
    /// The bodies by name and the place in these of that of each cell; empty where the
    /// file does not tell bodies apart.
    std::vector<std::string> body_names;
    std::vector<std::size_t> body_of_cell;
    std::map<std::string, unsigned int> boundary_names;
    std::map<std::string, unsigned int> material_names;
    /// How such a file gets names of boundaries, as a clause for messages.
    std::string how_to_name_boundaries;

    /// How many elements there are of kinds that are no use: "pyramids".
    std::map<std::string, std::size_t> other_elements;

    /// What of the file is left out, a sentence each without the file's name.
    std::vector<std::string> left_out;

    /// Where the file seems to be damaged, likewise.
    std::vector<std::string> damages;

    /// How many elements of the file were cut into the cells, by kinds:
    /// "tetrahedra". Empty if the cells are those of the file.
    std::map<std::string, std::size_t> cut_elements;

    /// In quotes if it has one, otherwise the number.
    std::string name_of_boundary(const dealii::types::boundary_id id) const
    {
      for (const auto &[name, number] : boundary_names)
        if (number == id)
          return "'" + name + "'";
      return std::to_string(id);
    }
  };

  /// What a cell is called.
  ///
  /// @param n_vertices 4, 6 or 8.
  inline std::string kind_of_cell(const std::size_t n_vertices)
  {
    return n_vertices == 4 ? "tetrahedron" : n_vertices == 6 ? "prism" : "hexahedron";
  }
} // namespace stiction
