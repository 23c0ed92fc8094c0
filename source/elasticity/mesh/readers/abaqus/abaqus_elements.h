#pragma once

#include <stiction/base/text/text_scanner.h>

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

  /// The same of flat elements, which among cells are faces: Gmsh writes its surfaces as
  /// plane ones. Shells and membranes are none, they have a stiffness.
  std::pair<std::int64_t, unsigned int> type_of_face(const std::string &type);

  /// The numbers of an element's nodes, which stand behind its own. Throws InputError if
  /// they are not as many as its type has.
  std::vector<std::int64_t> nodes_of(const std::vector<std::string> &items,
                                     unsigned int n_nodes, const std::string &type,
                                     const TextScanner &text);

  extern const std::string understood_elements; ///< the end of a sentence

  /// 0 of S1. Throws InputError if it is none from S1 to S6.
  unsigned int face_number(const std::string &face, const TextScanner &text);

  /// The faces S1, S2, ... of Abaqus' manual, by the numbers of deal.II's vertices.
  const std::vector<std::vector<unsigned int>> &faces_of(std::size_t n_vertices);
} // namespace stiction::abaqus
