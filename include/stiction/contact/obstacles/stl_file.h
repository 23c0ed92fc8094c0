#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace stiction
{
  /// Triangles that share their vertices.
  struct TriangulatedSurface
  {
    std::vector<dealii::Point<3>> vertices; ///< m
    /// Counterclockwise as seen from outside.
    std::vector<std::array<unsigned int, 3>> triangles;
  };

  /// Reads an STL file, text or binary. The order of the vertices counts, not
  /// the normals in the file; vertices at the same place are one; triangles
  /// without an area are left out.
  ///
  /// @param description the beginning of a sentence about the entry and its
  ///   value, see ParameterFile::describe().
  ///
  /// Throws InputError if the file cannot be read, is no STL file, or has no
  /// triangle with an area.
  TriangulatedSurface read_stl(const std::string &file, const std::string &description);
} // namespace stiction
