#pragma once

#include <stiction/base/text/text_scanner.h>
#include <stiction/elasticity/mesh/readers/mesh_data.h>

#include <array>
#include <cstdint>
#include <unordered_map>

namespace stiction
{
  /// Puts a mesh together from nodes and elements as a file numbers them.
  /// Whatever it refuses, it does so with the line that the file is at.
  class MeshBuilder
  {
  public:
    using Nodes = std::vector<std::int64_t>; ///< numbers of nodes

    explicit MeshBuilder(const TextScanner &text)
      : text_(text)
    {
    }

    /// A kind of elements.
    struct Kind
    {
      unsigned int n_nodes;
      std::string name; ///< "tetrahedra", empty if they do not matter
      unsigned int n_corners = 0;
    };

    /// Those of the type that Gmsh gives this number. Throws InputError if they
    /// are not of first or second order.
    const Kind &element_kind(std::int64_t type) const;

    /// Numbers of nodes begin anew: what follows belongs to another part.
    void forget_numbers() { positions_.clear(); }

    /// Throws InputError if there is a node of this number already.
    void add_node(std::int64_t number, const dealii::Point<3> &point);

    /// Of elements that are no use it notes how many there are.
    ///
    /// @param type as for element_kind().
    /// @param id of the boundary or the material.
    /// @param nodes in Gmsh's order.
    ///
    /// Throws InputError if the id is negative or absurd, if it does not have
    /// as many nodes as its type or some that were not added, or if a
    /// neighbour has another node inside of the same edge or face.
    void add_element(std::int64_t type, std::int64_t id, const Nodes &nodes);

    /// A face of a cell, by its vertices in mesh.cells as they go around it.
    void add_face(unsigned int id, const std::vector<unsigned int> &vertices);

    /// Gives a boundary or a material a name. Throws InputError if a parameter
    /// file could not use the name or if it is that of another part already.
    void add_name(const std::string &name, std::int64_t id,
                  std::map<std::string, unsigned int> &names) const;

    /// Whether there are cells and nothing that is no use.
    bool is_of_cells() const;

    /// The mesh, if it is of cells with vertices, nodes inside and positive
    /// volumes.
    ///
    /// Throws InputError if a cell has no volume in any order of nodes.
    MeshData finish();

    /// Has no vertices and no nodes inside yet. Those of cells and faces are
    /// nodes in the order of the file, from 0.
    MeshData mesh;

  private:
    unsigned int to_id(std::int64_t number) const;

    void add_inner_nodes(const Kind &kind, const std::vector<unsigned int> &nodes);

    void make_volumes_positive();

    std::vector<dealii::Point<3>> from_first_node(const dealii::CellData<3> &cell) const;

    // Whether it has a volume, which is positive then.
    bool turn_hexahedron(dealii::CellData<3> &cell) const;
    bool turn(dealii::CellData<3> &cell) const;

    const TextScanner &text_;
    std::unordered_map<std::int64_t, unsigned int> positions_; // in points_
    std::vector<dealii::Point<3>> points_;
    // by the sorted corners of the edge, face or cell that they are inside of
    std::map<std::vector<unsigned int>, unsigned int> inner_nodes_;
  };

  /// Nodes of a cell of second order, which Abaqus and VTK number alike but for
  /// those inside of a hexahedron and its faces, in the order of Gmsh. Any other
  /// number of nodes is left as it is.
  ///
  /// @param faces_and_centre where Gmsh's nodes 20 to 26 of a hexahedron are.
  MeshBuilder::Nodes in_gmsh_order(const MeshBuilder::Nodes &nodes,
                                   const std::array<unsigned int, 7> &faces_and_centre);

  /// The readers of the formats.
  MeshData read_gmsh(TextScanner &text);

  MeshData read_abaqus(TextScanner &text);

  MeshData read_vtk(TextScanner &text);
} // namespace stiction
