#pragma once

#include <stiction/elasticity/mesh/readers/mesh_data.h>

#include <set>
#include <string>

namespace stiction
{
  /// Reads a mesh of tetrahedra with 4 or 10 nodes, prisms with 6, 15 or 18, and
  /// hexahedra with 8, 20 or 27; the extension says which: .msh (Gmsh, 2.2 or
  /// 4.1), .inp (Abaqus), .vtk (legacy VTK), all as text. What is no mesh of
  /// hexahedra is cut into them, see cut_into_hexahedra().
  ///
  /// Nodes that are no corner of a cell are no vertices.
  ///
  /// @param location the beginning of a sentence about the file.
  /// @param in_use the boundaries that are asked for later, by names or numbers: a face
  ///   on several goes to the one that is.
  ///
  /// Throws InputError if the file cannot be read, is none of these, has other
  /// elements than these, contradicts itself, or if they do not make one body.
  MeshData read_mesh_file(const std::string &file, const std::string &location,
                          const std::set<std::string> &in_use);
} // namespace stiction
