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

  std::pair<std::int64_t, unsigned int> type_of_face(const std::string &type)
  {
    static const std::map<char, std::int64_t> types = {
      {'3', 2}, {'4', 3}, {'6', 9}, {'8', 16}, {'9', 10}};
    for (const std::string name : {"CPS", "CPE", "SFM3D"})
      if (type.rfind(name, 0) == 0 && types.count(type.c_str()[name.size()]) > 0)
        {
          const char n_nodes = type[name.size()];
          return {types.at(n_nodes), n_nodes - '0'};
        }
    return {0, 0};
  }

  const std::string understood_elements =
    "tetrahedra (C3D4, C3D10), prisms (C3D6, C3D15) or hexahedra (C3D8, C3D20, C3D27)";

  std::vector<std::int64_t> nodes_of(const std::vector<std::string> &items,
                                     const unsigned int n_nodes, const std::string &type,
                                     const TextScanner &text)
  {
    if (items.size() != n_nodes + 1)
      text.refuse("an element with its number and " + std::to_string(n_nodes) +
                  " nodes should stand here, not " + std::to_string(items.size() - 1) +
                  " nodes, as it is of type " + type + "; understood are " +
                  understood_elements);
    std::vector<std::int64_t> nodes;
    for (unsigned int i = 1; i <= n_nodes; ++i)
      nodes.push_back(text.to_integer(items[i]));
    return nodes;
  }

  unsigned int face_number(const std::string &face, const TextScanner &text)
  {
    if (face.size() != 2 || (face[0] != 'S' && face[0] != 's') || face[1] < '1' ||
        face[1] > '6')
      text.refuse("'" + face.substr(0, 40) +
                  "' is no face of an element, must be from S1 to S6");
    return static_cast<unsigned int>(face[1] - '1');
  }

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
