#ifndef stiction_elasticity_mesh_file_h
#define stiction_elasticity_mesh_file_h

#include <stiction/elasticity/mesh_data.h>

namespace stiction
{
  /// Reads a mesh of linear hexahedra; the extension says what the file is:
  /// .msh (Gmsh, 2.2 or 4.1), .inp (Abaqus), .vtk (legacy VTK), all as text.
  ///
  /// deal.II's GridIn reads these too, but it drops the names, gives surfaces
  /// of an .inp file the digits in their names as ids, and in a Release build
  /// it does not survive files that are damaged.
  ///
  /// Vertices that no cell has are left out.
  ///
  /// @param location the beginning of a sentence about the file.
  ///
  /// Throws InputError if the file cannot be read, is none of these, has other
  /// elements than linear hexahedra, contradicts itself, or if its hexahedra
  /// do not make one body.
  MeshData
  read_mesh_file(const std::string &file, const std::string &location);
} // namespace stiction

#endif
