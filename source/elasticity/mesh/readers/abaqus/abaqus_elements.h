#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// The elements of Abaqus by its names for them.
namespace stiction::abaqus
{
  bool begins_with_any(const std::string &text,
                       const std::vector<std::string> &beginnings);

  /// The type that Gmsh has for it and how many nodes it has, which is what
  /// its name says; 0 if it is none. Other letters, as for reduced integration,
  /// say nothing of the shape.
  std::pair<std::int64_t, unsigned int> type_of_cell(const std::string &type);

  extern const std::string understood_elements; ///< the end of a sentence

  /// The faces S1, S2, ... of Abaqus' manual, by the numbers of deal.II's vertices.
  const std::vector<std::vector<unsigned int>> &faces_of(std::size_t n_vertices);
} // namespace stiction::abaqus
