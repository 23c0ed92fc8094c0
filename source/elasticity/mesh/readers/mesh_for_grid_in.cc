#include "mesh_for_grid_in.h"

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <sstream>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Keeps what GridIn hands over without making a mesh of it, which would
    // not survive hexahedra that do not fit together.
    class Kept : public Triangulation<3>
    {
    public:
      void create_triangulation(const std::vector<Point<3>> &vertices,
                                const std::vector<CellData<3>> &cells,
                                const SubCellData &faces) override
      {
        data.vertices = vertices;
        data.cells    = cells;
        data.faces    = faces;
      }

      MeshData data;
    };

    std::vector<std::string> split_at_spaces(const std::string &text)
    {
      std::istringstream in(text);
      return {std::istream_iterator<std::string>(in), {}};
    }
  } // namespace

  const std::pair<unsigned int, std::string> &element_kind(const std::int64_t type,
                                                           const MeshText &text)
  {
    static const std::map<std::int64_t, std::pair<unsigned int, std::string>> kinds = {
      {15, {1, ""}},
      {1, {2, ""}},
      {2, {3, "triangles"}},
      {3, {4, ""}},
      {4, {4, "tetrahedra"}},
      {5, {8, ""}},
      {6, {6, "wedges"}},
      {7, {5, "pyramids"}},
      // of second order
      {8, {3, ""}},
      {9, {6, "triangles"}},
      {10, {9, ""}},
      {11, {10, "tetrahedra"}},
      {12, {27, ""}},
      {13, {18, "wedges"}},
      {14, {14, "pyramids"}},
      {16, {8, ""}},
      {17, {20, ""}},
      {18, {15, "wedges"}},
      {19, {13, "pyramids"}}};
    const auto kind = kinds.find(type);
    if (kind == kinds.end())
      text.refuse("has elements of Gmsh's type " + std::to_string(type) +
                  ", must be hexahedra of first or second order, 'gmsh -order "
                  "2' writes elements of second order");
    return kind->second;
  }

  std::string in_gmsh_order(const std::string &nodes,
                            const std::array<unsigned int, 7> &faces_and_centre)
  {
    const std::vector<std::string> words = split_at_spaces(nodes);
    if (words.size() != 20 && words.size() != 27)
      return nodes;
    std::vector<unsigned int> order = {0,  1, 2,  3,  4,  5,  6,  7,  8,  11,
                                       16, 9, 17, 10, 18, 19, 12, 15, 13, 14};
    order.insert(order.end(), faces_and_centre.begin(), faces_and_centre.end());
    std::string line;
    for (std::size_t i = 0; i < words.size(); ++i)
      line += words[order[i]] + ' ';
    return line;
  }

  void MeshForGridIn::add_node(const std::int64_t number, const std::string &coordinates,
                               const MeshText &text)
  {
    if (std::abs(number) > std::numeric_limits<int>::max())
      text.refuse("node " + std::to_string(number) +
                  " has a number that is too large, must be below 2147483648");
    const std::vector<std::string> words = split_at_spaces(coordinates);
    if (words.size() != 3)
      text.refuse("node " + std::to_string(number) + " must have three coordinates");
    Point<3> point;
    for (unsigned int d = 0; d < 3; ++d)
      point[d] = text.to_real(words[d]);
    if (!numbers_.emplace(std::to_string(number), points_.size()).second)
      text.refuse("node " + std::to_string(number) + " stands twice, must stand once");
    points_.push_back(point);
    is_corner_.push_back(false);
    nodes_ += std::to_string(number) + ' ' + coordinates + '\n';
  }

  void MeshForGridIn::add_element(const std::int64_t type, const unsigned int id,
                                  const std::string &nodes, const MeshText &text)
  {
    const std::vector<std::string> words = split_at_spaces(nodes);
    std::vector<unsigned int> positions;
    for (const std::string &node : words)
      positions.push_back(position_of_node(node, text));
    const auto &kind = element_kind(type, text);
    if (words.size() != kind.first)
      text.refuse("an element has " + std::to_string(words.size()) +
                  " nodes, must have " + std::to_string(kind.first));

    if (!kind.second.empty())
      ++mesh.other_elements[kind.second];
    const bool is_cell = type == 5 || type == 17 || type == 12;
    if (!is_cell && type != 3 && type != 16 && type != 10)
      return;
    const unsigned int n_corners = is_cell ? 8 : 4;
    std::string line =
      "0 " + std::string(is_cell ? "5" : "3") + " 1 " + std::to_string(id);
    for (unsigned int i = 0; i < n_corners; ++i)
      line += ' ' + words[i];
    (is_cell ? hexahedra_ : faces_).push_back(line + '\n');
    if (!is_cell)
      return;
    for (unsigned int i = 0; i < n_corners; ++i)
      is_corner_[positions[i]] = true;
    add_inner_nodes(positions, text);
  }

  unsigned int MeshForGridIn::position_of_node(const std::string &number,
                                               const MeshText &text) const
  {
    auto found = numbers_.find(number);
    if (found == numbers_.end()) // '007' is node 7
      found = numbers_.find(std::to_string(text.to_integer(number)));
    if (found == numbers_.end())
      text.refuse("there is no node " + number.substr(0, 40));
    return found->second;
  }

  void MeshForGridIn::add_inner_nodes(const std::vector<unsigned int> &nodes,
                                      const MeshText &text)
  {
    // what nodes 8 to 26 are inside of
    static const std::array<std::string, 19> corners_of = {
      {"01", "03", "04", "12", "15", "23", "26", "37", "45", "47", "56", "67", "0123",
       "0145", "0347", "1256", "2367", "4567", "01234567"}};
    for (unsigned int i = 8; i < nodes.size(); ++i)
      {
        std::vector<unsigned int> corners;
        for (const char corner : corners_of[i - 8])
          corners.push_back(nodes[corner - '0']);
        std::sort(corners.begin(), corners.end());
        if (inner_nodes_.emplace(corners, nodes[i]).first->second != nodes[i])
          text.refuse("a hexahedron has another node " + std::to_string(i + 1) +
                      " than a neighbour inside of the same " +
                      (corners.size() == 2 ? "edge" : "face") +
                      ", neighbours must have the same nodes");
      }
  }

  QuadraticCells::InnerNodes MeshForGridIn::inner_nodes() const
  {
    std::vector<unsigned int> vertices; // by the position of their node
    unsigned int n = 0;
    for (const bool is_corner : is_corner_)
      vertices.push_back(is_corner ? n++ : numbers::invalid_unsigned_int);
    QuadraticCells::InnerNodes points;
    for (const auto &node : inner_nodes_)
      {
        std::vector<unsigned int> corners = node.first;
        for (unsigned int &corner : corners)
          corner = vertices[corner];
        points.emplace(corners, points_[node.second]);
      }
    return points;
  }

  bool MeshForGridIn::is_of_hexahedra() const
  {
    return !hexahedra_.empty() && mesh.other_elements.empty();
  }

  MeshData MeshForGridIn::read(const MeshText &text) const
  {
    if (!is_of_hexahedra())
      {
        MeshData others = mesh;
        others.faces.boundary_quads.resize(faces_.size());
        return others;
      }

    Kept kept;
    if (!hand_over(0, hexahedra_.size(), kept))
      {
        // halves the hexahedra among which one is refused
        std::size_t first = 0, n = hexahedra_.size();
        while (n > 1)
          if (hand_over(first, n / 2, kept))
            {
              first += n / 2;
              n -= n / 2;
            }
          else
            n /= 2;
        text.refuse("hexahedron " + std::to_string(first + 1) +
                    " up to here is inverted or degenerate, its corners must "
                    "make a hexahedron that is not folded");
      }
    MeshData &data = kept.data;
    data.faces.boundary_quads.erase(data.faces.boundary_quads.begin());
    data.inner_nodes    = inner_nodes();
    data.boundary_names = mesh.boundary_names;
    data.material_names = mesh.material_names;
    return data;
  }

  bool MeshForGridIn::hand_over(const std::size_t first, const std::size_t n,
                                Triangulation<3> &triangulation) const
  {
    // A triangle keeps GridIn from putting vertices and cells in order, which
    // it can do only if they fit together.
    std::stringstream file;
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
         << numbers_.size() << '\n'
         << nodes_ << "$EndNodes\n$Elements\n"
         << n + faces_.size() + 1 << "\n0 2 0 0 0 0\n";
    for (std::size_t i = first; i < first + n; ++i)
      file << hexahedra_[i];
    for (const std::string &face : faces_)
      file << face;
    file << "$EndElements\n";
    file.exceptions(std::ios::failbit | std::ios::badbit);
    try
      {
        GridIn<3>(triangulation).read_msh(file);
      }
    catch (const std::exception &)
      {
        return false;
      }
    return true;
  }
} // namespace stiction
