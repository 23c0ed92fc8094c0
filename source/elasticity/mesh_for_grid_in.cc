#include "mesh_for_grid_in.h"

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

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
      void
      create_triangulation(const std::vector<Point<3>> &vertices,
                           const std::vector<CellData<3>> &cells,
                           const SubCellData &faces) override
      {
        data.vertices = vertices;
        data.cells    = cells;
        data.faces    = faces;
      }

      MeshData data;
    };

    std::vector<std::string>
    split_at_spaces(const std::string &text)
    {
      std::istringstream in(text);
      return {std::istream_iterator<std::string>(in), {}};
    }
  } // namespace



  const std::pair<unsigned int, std::string> &
  element_kind(const std::int64_t type, const MeshText &text)
  {
    static const std::map<std::int64_t, std::pair<unsigned int, std::string>>
      kinds         = {{15, {1, ""}},
                       {1, {2, ""}},
                       {2, {3, "triangles"}},
                       {3, {4, ""}},
                       {4, {4, "tetrahedra"}},
                       {5, {8, ""}},
                       {6, {6, "wedges"}},
                       {7, {5, "pyramids"}}};
    const auto kind = kinds.find(type);
    if (kind == kinds.end())
      text.refuse("has elements of Gmsh's type " + std::to_string(type) +
                  ", must be linear hexahedra, 'gmsh -order 1' writes "
                  "elements of first order");
    return kind->second;
  }



  void
  MeshForGridIn::add_node(const std::int64_t number,
                          const std::string &coordinates,
                          const MeshText &text)
  {
    if (std::abs(number) > std::numeric_limits<int>::max())
      text.refuse("node " + std::to_string(number) +
                  " has a number that is too large, must be below 2147483648");
    const std::vector<std::string> words = split_at_spaces(coordinates);
    for (const std::string &word : words)
      text.to_real(word);
    if (words.size() != 3)
      text.refuse("node " + std::to_string(number) +
                  " must have three coordinates");
    if (!numbers_.insert(std::to_string(number)).second)
      text.refuse("node " + std::to_string(number) +
                  " stands twice, must stand once");
    nodes_ += std::to_string(number) + ' ' + coordinates + '\n';
  }



  void
  MeshForGridIn::add_element(const std::int64_t type,
                             const unsigned int id,
                             const std::string &nodes,
                             const MeshText &text)
  {
    const std::vector<std::string> words = split_at_spaces(nodes);
    for (const std::string &node : words)
      // '007' is node 7
      if (numbers_.count(node) == 0 &&
          numbers_.count(std::to_string(text.to_integer(node))) == 0)
        text.refuse("there is no node " + node.substr(0, 40));
    const auto &kind = element_kind(type, text);
    if (words.size() != kind.first)
      text.refuse("an element has " + std::to_string(words.size()) +
                  " nodes, must have " + std::to_string(kind.first));

    if (!kind.second.empty())
      ++mesh.other_elements[kind.second];
    if (type != 3 && type != 5)
      return;
    (type == 5 ? hexahedra_ : faces_)
      .push_back("0 " + std::to_string(type) + " 1 " + std::to_string(id) +
                 ' ' + nodes + '\n');
  }



  bool
  MeshForGridIn::is_of_hexahedra() const
  {
    return !hexahedra_.empty() && mesh.other_elements.empty();
  }



  MeshData
  MeshForGridIn::read(const MeshText &text) const
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
    data.boundary_names = mesh.boundary_names;
    data.material_names = mesh.material_names;
    return data;
  }



  bool
  MeshForGridIn::hand_over(const std::size_t first,
                           const std::size_t n,
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
