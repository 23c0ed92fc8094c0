#include "mesh_for_grid_in.h"

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <iterator>
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
    split(const std::string &text)
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
  MeshForGridIn::add_node(const std::string &number,
                          const std::string &coordinates,
                          const MeshText &text)
  {
    text.to_integer(number);
    if (split(coordinates).size() != 3)
      text.refuse("node " + number + " must have three coordinates");
    if (!numbers_.insert(number).second)
      text.refuse("node " + number + " stands twice, must stand once");
    nodes_ += number + ' ' + coordinates + '\n';
    node_lines_.push_back(text.line());
  }



  void
  MeshForGridIn::add_element(const std::int64_t type,
                             const unsigned int id,
                             const std::string &nodes,
                             const MeshText &text)
  {
    const std::vector<std::string> words = split(nodes);
    for (const std::string &node : words)
      if (numbers_.count(node) == 0)
        text.refuse("there is no node " + node.substr(0, 40));
    const auto &kind = element_kind(type, text);
    if (words.size() != kind.first)
      text.refuse("an element has " + std::to_string(words.size()) +
                  " nodes, must have " + std::to_string(kind.first));

    if (!kind.second.empty())
      ++mesh.other_elements[kind.second];
    if (type != 3 && type != 5)
      return;
    n_hexahedra_ += type == 5 ? 1 : 0;
    n_faces_ += type == 3 ? 1 : 0;
    elements_ += "0 " + std::to_string(type) + " 1 " + std::to_string(id) +
                 ' ' + nodes + '\n';
  }



  bool
  MeshForGridIn::is_of_hexahedra() const
  {
    return n_hexahedra_ > 0 && mesh.other_elements.empty();
  }



  MeshData
  MeshForGridIn::read(const MeshText &text) const
  {
    if (!is_of_hexahedra())
      {
        MeshData others = mesh;
        others.faces.boundary_quads.resize(n_faces_);
        return others;
      }

    // A triangle keeps GridIn from putting vertices and cells in order, which
    // it can do only if they fit together.
    const std::string n_nodes    = std::to_string(node_lines_.size());
    const std::string n_elements = std::to_string(n_hexahedra_ + n_faces_ + 1);
    const std::string file = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" +
                             n_nodes + '\n' + nodes_ +
                             "$EndNodes\n$Elements\n" + n_elements +
                             "\n0 2 0 0 0 0\n" + elements_ + "$EndElements\n";
    std::istringstream in(file);
    in.exceptions(std::ios::failbit | std::ios::badbit);
    Kept kept;
    try
      {
        GridIn<3>(kept).read_msh(in);
      }
    catch (const std::ios::failure &)
      {
        in.exceptions(std::ios::goodbit);
        in.clear();
        const auto stop  = static_cast<std::size_t>(in.tellg());
        const auto begin = file.find_last_of(" \n", stop - 1) + 1;
        const auto end   = file.find_first_of(" \n", begin);
        const auto line =
          std::count(file.begin(),
                     file.begin() + static_cast<std::ptrdiff_t>(begin),
                     '\n') -
          5;
        text.refuse(
          "'" + file.substr(begin, std::min<std::size_t>(end - begin, 40)) +
            "' stands where a number should, or is too large",
          node_lines_.at(static_cast<std::size_t>(line)));
      }
    catch (const ExceptionBase &)
      {
        text.refuse("has a hexahedron without volume, must be of hexahedra "
                    "that are not folded");
      }
    MeshData &data = kept.data;
    data.faces.boundary_quads.erase(data.faces.boundary_quads.begin());
    data.boundary_names = mesh.boundary_names;
    data.material_names = mesh.material_names;
    return data;
  }
} // namespace stiction
