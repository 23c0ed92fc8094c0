#include "mesh_builder.h"

#include <stiction/base/text/utf8.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace stiction
{
  using namespace dealii;

  const MeshBuilder::Kind &MeshBuilder::element_kind(const std::int64_t type) const
  {
    static const std::map<std::int64_t, Kind> kinds = {{15, {1, ""}},
                                                       {1, {2, ""}},
                                                       {2, {3, "triangles", 3}},
                                                       {3, {4, "quadrilaterals", 4}},
                                                       {4, {4, "tetrahedra", 4}},
                                                       {5, {8, "hexahedra", 8}},
                                                       {6, {6, "prisms", 6}},
                                                       {7, {5, "pyramids"}},
                                                       // of second order
                                                       {8, {3, ""}},
                                                       {9, {6, "triangles", 3}},
                                                       {10, {9, "quadrilaterals", 4}},
                                                       {11, {10, "tetrahedra", 4}},
                                                       {12, {27, "hexahedra", 8}},
                                                       {13, {18, "prisms", 6}},
                                                       {14, {14, "pyramids"}},
                                                       {16, {8, "quadrilaterals", 4}},
                                                       {17, {20, "hexahedra", 8}},
                                                       {18, {15, "prisms", 6}},
                                                       {19, {13, "pyramids"}}};
    const auto kind                                 = kinds.find(type);
    if (kind == kinds.end())
      text_.refuse("has elements of Gmsh's type " + std::to_string(type) +
                   ", must be tetrahedra, prisms or hexahedra of first or second "
                   "order, 'gmsh -order 2' writes elements of second order");
    return kind->second;
  }

  void MeshBuilder::add_node(const std::int64_t number, const Point<3> &point)
  {
    if (std::abs(number) > std::numeric_limits<int>::max())
      text_.refuse("node " + std::to_string(number) +
                   " has a number that is too large, must be below 2147483648");
    if (!positions_.emplace(number, points_.size()).second)
      text_.refuse("node " + std::to_string(number) + " stands twice, must stand once");
    points_.push_back(point);
  }

  void MeshBuilder::add_element(const std::int64_t type, const std::int64_t id,
                                const Nodes &nodes)
  {
    const unsigned int part = to_id(id);
    std::vector<unsigned int> positions;
    for (const std::int64_t node : nodes)
      {
        const auto found = positions_.find(node);
        if (found == positions_.end())
          text_.refuse("there is no node " + std::to_string(node));
        positions.push_back(found->second);
      }
    const Kind &kind = element_kind(type);
    if (nodes.size() != kind.n_nodes)
      text_.refuse("an element has " + std::to_string(nodes.size()) +
                   " nodes, must have " + std::to_string(kind.n_nodes));

    if (kind.name == "triangles" || kind.name == "quadrilaterals")
      add_face(part, {positions.begin(), positions.begin() + kind.n_corners});
    else if (kind.n_corners > 0)
      {
        mesh.cells.emplace_back(kind.n_corners);
        mesh.cells.back().material_id = part;
        for (unsigned int v = 0; v < kind.n_corners; ++v)
          mesh.cells.back()
            .vertices[kind.n_corners == 8 ? GeometryInfo<3>::ucd_to_deal[v] : v] =
            positions[v];
        add_inner_nodes(kind, positions);
      }
    else if (!kind.name.empty())
      ++mesh.other_elements[kind.name];
  }

  void MeshBuilder::add_face(const unsigned int id,
                             const std::vector<unsigned int> &vertices)
  {
    mesh.faces.boundary_quads.emplace_back();
    mesh.faces.boundary_quads.back().boundary_id = id;
    mesh.faces.boundary_quads.back().vertices    = vertices;
  }

  void MeshBuilder::add_inner_nodes(const Kind &kind,
                                    const std::vector<unsigned int> &nodes)
  {
    // what the nodes behind the corners are inside of, by kinds
    static const std::map<unsigned int, std::vector<std::string>> corners_of = {
      {4, {"01", "12", "02", "03", "23", "13"}},
      {6, {"01", "02", "03", "12", "14", "25", "34", "35", "45", "0134", "0235", "1245"}},
      {8,
       {"01", "03", "04", "12", "15", "23", "26", "37", "45", "47", "56", "67", "0123",
        "0145", "0347", "1256", "2367", "4567", "01234567"}}};
    for (unsigned int i = kind.n_corners; i < nodes.size(); ++i)
      {
        std::vector<unsigned int> corners;
        for (const char corner : corners_of.at(kind.n_corners)[i - kind.n_corners])
          corners.push_back(nodes[corner - '0']);
        std::sort(corners.begin(), corners.end());
        if (inner_nodes_.emplace(corners, nodes[i]).first->second != nodes[i])
          text_.refuse("a " + kind_of_cell(kind.n_corners) + " has another node " +
                       std::to_string(i + 1) + " than a neighbour inside of the same " +
                       (corners.size() == 2 ? "edge" : "face") +
                       ", neighbours must have the same nodes");
      }
  }

  unsigned int MeshBuilder::to_id(const std::int64_t number) const
  {
    if (number < 0 || number > 999999999)
      text_.refuse("'" + std::to_string(number) +
                   "' is no number for a boundary or a material, must be from "
                   "0 to 999999999");
    return static_cast<unsigned int>(number);
  }

  void MeshBuilder::add_name(const std::string &name, const std::int64_t id,
                             std::map<std::string, unsigned int> &names) const
  {
    const unsigned int part = to_id(id);
    if (name.empty() || name.find_first_of(":|;#") != std::string::npos ||
        Utilities::trim(name) != name ||
        std::any_of(name.begin(), name.end(),
                    [](const unsigned char c) { return std::iscntrl(c) != 0; }))
      text_.refuse("'" + name +
                   "' is no name that a parameter file could use, must be a "
                   "word or words without ':', '|', ';' and '#'");
    const std::size_t bad = first_byte_not_utf8(name);
    if (bad != std::string::npos)
      text_.refuse("byte " + std::to_string(bad + 1) + " of the name '" + name +
                   "' is no UTF-8, names must be in UTF-8, 'iconv -f latin1 -t "
                   "utf-8' makes that of a file in Latin-1");
    if (name.find_first_not_of("0123456789") == std::string::npos &&
        name != std::to_string(part))
      text_.refuse("'" + name + "' is the name of number " + std::to_string(part) +
                   ", must not be another number");
    const unsigned int known = names.emplace(name, part).first->second;
    if (known != part)
      text_.refuse("'" + name + "' is the name of number " + std::to_string(known) +
                   " already, must be that of one");
  }

  bool MeshBuilder::is_of_cells() const
  {
    return !mesh.cells.empty() && mesh.other_elements.empty();
  }

  MeshData MeshBuilder::finish()
  {
    if (!is_of_cells())
      return mesh;
    make_volumes_positive();

    // Nodes that are no corner of a cell are no vertices.
    std::vector<unsigned int> vertices(points_.size(), numbers::invalid_unsigned_int);
    for (const CellData<3> &cell : mesh.cells)
      for (const unsigned int node : cell.vertices)
        vertices[node] = 0;
    for (std::size_t node = 0; node < points_.size(); ++node)
      if (vertices[node] == 0)
        {
          vertices[node] = mesh.vertices.size();
          mesh.vertices.push_back(points_[node]);
        }
    const auto renumbered = [&](std::vector<unsigned int> nodes) {
      for (unsigned int &node : nodes)
        node = vertices[node];
      return nodes;
    };
    for (CellData<3> &cell : mesh.cells)
      cell.vertices = renumbered(cell.vertices);
    for (CellData<2> &face : mesh.faces.boundary_quads)
      face.vertices = renumbered(face.vertices);
    for (const auto &[corners, node] : inner_nodes_)
      mesh.inner_nodes.emplace(renumbered(corners), points_[node]);
    return std::move(mesh);
  }

  void MeshBuilder::make_volumes_positive()
  {
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
      {
        CellData<3> &cell = mesh.cells[i];
        if (cell.vertices.size() == 8 ? turn_hexahedron(cell) : turn(cell))
          continue;
        const std::string kind = kind_of_cell(cell.vertices.size());
        text_.refuse(kind + ' ' + std::to_string(i + 1) +
                     " up to here is inverted or degenerate, its corners must make a " +
                     kind + " that is not folded");
      }
  }

  // Volumes of cells far from the origin would be rounding.
  std::vector<Point<3>> MeshBuilder::from_first_node(const CellData<3> &cell) const
  {
    std::vector<Point<3>> points;
    for (const unsigned int v : cell.vertices)
      points.emplace_back(points_[v] - points_[cell.vertices[0]]);
    return points;
  }

  bool MeshBuilder::turn_hexahedron(CellData<3> &cell) const
  {
    std::vector<CellData<3>> cells = {cell};
    std::iota(cells[0].vertices.begin(), cells[0].vertices.end(), 0u);
    try
      {
        GridTools::invert_cells_with_negative_measure(from_first_node(cell), cells);
      }
    catch (const ExceptionBase &)
      {
        return false;
      }
    const std::vector<unsigned int> nodes = cell.vertices;
    std::transform(cells[0].vertices.begin(), cells[0].vertices.end(),
                   cell.vertices.begin(), [&](const unsigned int v) { return nodes[v]; });
    return true;
  }

  // deal.II's function knows no prisms.
  bool MeshBuilder::turn(CellData<3> &cell) const
  {
    auto &vertices    = cell.vertices;
    const auto points = from_first_node(cell);
    double size       = 0.;
    for (const Point<3> &point : points)
      size = std::max(size, point.norm());
    std::vector<unsigned int> in_order(points.size());
    std::iota(in_order.begin(), in_order.end(), 0u);
    const double volume = GridTools::cell_measure<3>(points, make_array_view(in_order));
    if (volume < 0. && vertices.size() == 4)
      std::swap(vertices[0], vertices[1]);
    else if (volume < 0.)
      std::swap_ranges(vertices.begin(), vertices.begin() + 3, vertices.begin() + 3);
    return std::abs(volume) > 1e-14 * size * size * size;
  }

  MeshBuilder::Nodes in_gmsh_order(const MeshBuilder::Nodes &nodes,
                                   const std::array<unsigned int, 7> &faces_and_centre)
  {
    std::vector<unsigned int> order;
    if (nodes.size() == 10) // a tetrahedron
      order = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
    else if (nodes.size() == 15 || nodes.size() == 18) // a prism
      order = {0, 1, 2, 3, 4, 5, 6, 8, 12, 7, 13, 14, 9, 11, 10, 15, 17, 16};
    else if (nodes.size() == 20 || nodes.size() == 27)
      {
        order = {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14};
        order.insert(order.end(), faces_and_centre.begin(), faces_and_centre.end());
      }
    else
      return nodes;
    MeshBuilder::Nodes ordered;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      ordered.push_back(nodes[order[i]]);
    return ordered;
  }
} // namespace stiction
