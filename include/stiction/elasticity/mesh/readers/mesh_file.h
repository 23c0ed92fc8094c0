#ifndef stiction_elasticity_mesh_readers_mesh_file_h
#define stiction_elasticity_mesh_readers_mesh_file_h

#include <stiction/elasticity/mesh/readers/mesh_data.h>

namespace stiction
{
  /// Reads a mesh of hexahedra with 8, 20 or 27 nodes; the extension says
  /// which: .msh (Gmsh, 2.2 or 4.1), .inp (Abaqus), .vtk (legacy VTK), all as
  /// text.
  ///
  /// Nodes that are no corner of a cell are no vertices.
  ///
  /// @param location the beginning of a sentence about the file.
  ///
  /// Throws InputError if the file cannot be read, is none of these, has other
  /// elements than such hexahedra, contradicts itself, or if its hexahedra
  /// do not make one body.
  MeshData read_mesh_file(const std::string &file, const std::string &location);
} // namespace stiction

#endif
