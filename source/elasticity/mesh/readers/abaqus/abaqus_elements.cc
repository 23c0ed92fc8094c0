#include "abaqus_elements.h"

#include <algorithm>
#include <map>

namespace stiction::abaqus
{
  bool begins_with_any(const std::string &text,
                       const std::vector<std::string> &beginnings)
  {
    return std::any_of(
      beginnings.begin(), beginnings.end(),
      [&](const std::string &beginning) { return text.rfind(beginning, 0) == 0; });
  }

  std::pair<std::int64_t, unsigned int> type_of_cell(const std::string &type)
  {
    static const std::map<unsigned int, std::int64_t> types = {
      {4, 4}, {6, 6}, {8, 5}, {10, 11}, {15, 18}, {20, 17}, {27, 12}};
    for (const auto &[n_nodes, gmsh_type] : types)
      {
        const std::string name = "C3D" + std::to_string(n_nodes);
        if (type == name ||
            begins_with_any(type, {name + 'R', name + 'I', name + 'H', name + 'M'}))
          return {gmsh_type, n_nodes};
      }
    return {0, 0};
  }

  const std::string understood_elements =
    "tetrahedra (C3D4, C3D10), prisms (C3D6, C3D15) or hexahedra (C3D8, C3D20, C3D27)";

  const std::vector<std::vector<unsigned int>> &faces_of(const std::size_t n_vertices)
  {
    static const std::map<std::size_t, std::vector<std::vector<unsigned int>>> faces = {
      {4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}},
      {6, {{0, 1, 2}, {3, 5, 4}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
      {8,
       {{0, 1, 5, 4},
        {2, 6, 7, 3},
        {0, 2, 3, 1},
        {1, 3, 7, 5},
        {5, 7, 6, 4},
        {4, 6, 2, 0}}}};
    return faces.at(n_vertices);
  }
} // namespace stiction::abaqus
