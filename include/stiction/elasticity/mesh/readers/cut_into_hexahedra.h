#pragma once

namespace stiction
{
  struct MeshData;

  /// Makes a conforming mesh of hexahedra of one with tetrahedra and prisms, and
  /// notes in MeshData::cut_elements what was cut. A mesh of hexahedra remains as
  /// it is.
  ///
  /// A tetrahedron is cut into four, one at each vertex, with nodes in the middle of
  /// edges, faces and cell; a prism into three along its axis. Where an edge of a
  /// triangle is halved, so is what is opposite to it in a quadrilateral, and
  /// opposite to that, and so on: a prism beside one with another axis is cut into
  /// six, a hexahedron beside prisms into two, four or eight.
  ///
  /// Faces keep their boundaries and cells their materials. The hexahedra cut from
  /// curved cells of second order have the nodes inside (MeshData::inner_nodes) with
  /// which they fill them exactly: a quadratic map of a piece that is itself the
  /// image of a cube under a trilinear map is triquadratic.
  void cut_into_hexahedra(MeshData &mesh);
} // namespace stiction
