#ifndef stiction_elasticity_mesh_for_grid_in_h
#define stiction_elasticity_mesh_for_grid_in_h

#include "mesh_text.h"

#include <deal.II/grid/tria.h>

#include <unordered_set>

namespace stiction
{
  /// How many nodes elements have of the type that Gmsh gives this number, and
  /// a name for what is no use. Throws InputError if they are not of first
  /// order.
  const std::pair<unsigned int, std::string> &
  element_kind(std::int64_t type, const MeshText &text);



  /// What is taken from a mesh file for deal.II's GridIn to read: a file of
  /// Gmsh's format 2.2, which is the one that GridIn checks most of. GridIn
  /// makes numbers of the words, finds the nodes and orders the vertices; it
  /// does not know names, nor much of what other programs write.
  class MeshForGridIn
  {
  public:
    /// Throws InputError if there is a node of this number already, or if they
    /// are no three numbers.
    ///
    /// @param coordinates three words.
    void
    add_node(std::int64_t number,
             const std::string &coordinates,
             const MeshText &text);

    /// Of elements that are no use it notes how many there are.
    ///
    /// @param type as for element_kind().
    /// @param id of the boundary or the material.
    /// @param nodes their numbers.
    ///
    /// Throws InputError if it does not have as many nodes as its type, or
    /// some that were not added.
    void
    add_element(std::int64_t type,
                unsigned int id,
                const std::string &nodes,
                const MeshText &text);

    /// Whether there are hexahedra and nothing that is no use.
    bool
    is_of_hexahedra() const;

    /// Has GridIn read it, if there are hexahedra and nothing that is no use.
    ///
    /// Throws InputError if a hexahedron has no volume in any order of nodes.
    MeshData
    read(const MeshText &text) const;

    /// What GridIn does not read: names and other elements.
    MeshData mesh;

  private:
    // Whether GridIn takes n hexahedra and all faces.
    bool
    hand_over(std::size_t first,
              std::size_t n,
              dealii::Triangulation<3> &triangulation) const;

    std::string nodes_;
    std::vector<std::string> hexahedra_, faces_;
    std::unordered_set<std::string> numbers_; // of nodes
  };
} // namespace stiction

#endif
