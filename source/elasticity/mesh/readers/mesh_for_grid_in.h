#ifndef stiction_source_elasticity_mesh_readers_mesh_for_grid_in_h
#define stiction_source_elasticity_mesh_readers_mesh_for_grid_in_h

#include "mesh_text.h"

#include <deal.II/grid/tria.h>

#include <array>
#include <unordered_map>

namespace stiction
{
  /// How many nodes elements have of the type that Gmsh gives this number, and
  /// a name for what is no use. Throws InputError if they are not of first or
  /// second order.
  const std::pair<unsigned int, std::string> &element_kind(std::int64_t type,
                                                           const MeshText &text);

  /// Nodes of a hexahedron of second order, which Abaqus and VTK number alike
  /// but for those inside of faces and the cell, in the order of Gmsh. Any
  /// other number of nodes is left as it is.
  ///
  /// @param faces_and_centre where Gmsh's nodes 20 to 26 are.
  std::string in_gmsh_order(const std::string &nodes,
                            const std::array<unsigned int, 7> &faces_and_centre);

  /// What is taken from a mesh file for deal.II's GridIn to read: a file of
  /// Gmsh's format 2.2, which is the one that GridIn checks most of. GridIn
  /// makes numbers of the words, finds the nodes and orders the vertices; it
  /// does not know names, nor much of what other programs write. Nodes inside
  /// of edges, faces and cells it does not get to see.
  class MeshForGridIn
  {
  public:
    /// Throws InputError if there is a node of this number already, or if they
    /// are no three numbers.
    ///
    /// @param coordinates three words.
    void add_node(std::int64_t number, const std::string &coordinates,
                  const MeshText &text);

    /// Of elements that are no use it notes how many there are.
    ///
    /// @param type as for element_kind().
    /// @param id of the boundary or the material.
    /// @param nodes their numbers, in Gmsh's order.
    ///
    /// Throws InputError if it does not have as many nodes as its type, or
    /// some that were not added, or if a neighbour has another node inside of
    /// the same edge or face.
    void add_element(std::int64_t type, unsigned int id, const std::string &nodes,
                     const MeshText &text);

    /// Whether there are hexahedra and nothing that is no use.
    bool is_of_hexahedra() const;

    /// Has GridIn read it, if there are hexahedra and nothing that is no use.
    ///
    /// Throws InputError if a hexahedron has no volume in any order of nodes.
    MeshData read(const MeshText &text) const;

    /// What GridIn does not read: names and other elements.
    MeshData mesh;

  private:
    // Whether GridIn takes n hexahedra and all faces.
    bool hand_over(std::size_t first, std::size_t n,
                   dealii::Triangulation<3> &triangulation) const;

    // In the order of the file, from 0. Throws InputError if there is none.
    unsigned int position_of_node(const std::string &number, const MeshText &text) const;

    void add_inner_nodes(const std::vector<unsigned int> &nodes, const MeshText &text);

    // those whose positions GridIn counts once it has dropped the others
    QuadraticCells::InnerNodes inner_nodes() const;

    std::string nodes_;
    std::vector<std::string> hexahedra_, faces_;
    std::unordered_map<std::string, unsigned int> numbers_; // of nodes
    // of nodes in the order of the file
    std::vector<dealii::Point<3>> points_;
    std::vector<bool> is_corner_;
    // by the sorted corners of the edge, face or cell that they are inside of
    std::map<std::vector<unsigned int>, unsigned int> inner_nodes_;
  };
} // namespace stiction

#endif
