#pragma once

// Writes a block of cubes that are cut into tetrahedra or prisms as Gmsh, Abaqus and
// VTK do. Its boundaries are left, right, front, back, bottom and top (1 to 6 in VTK);
// its lowest layer of cubes is of the material 'lower' (7), the others are of 'upper'
// (8).

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

class CutBlockFile
{
public:
  using Place = std::array<unsigned int, 3>; // in halves of a cube

  // What a cube is: 'h' a hexahedron, 't' six tetrahedra, 'z' or 'y' two prisms along
  // that axis.
  using Kind = std::function<char(const Place &cube)>;

  using Map = std::function<dealii::Point<3>(dealii::Point<3>)>; // of the unit cube

  CutBlockFile(const Place &n_cubes, const Kind &kind, const Map &map,
               const unsigned int order)
    : n_(n_cubes)
    , map_(map)
    , order_(order)
  {
    for (unsigned int k = 0; k < n_[2]; ++k)
      for (unsigned int j = 0; j < n_[1]; ++j)
        for (unsigned int i = 0; i < n_[0]; ++i)
          add_cube({{2 * i, 2 * j, 2 * k}}, kind({{i, j, k}}));
  }

  void write(const std::string &file)
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ofstream out(file);
        out.precision(17);
        const std::string format = file.substr(file.size() - 3);
        format == "msh"   ? write_gmsh(out)
        : format == "inp" ? write_abaqus(out)
                          : write_vtk(out);
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }

private:
  struct Element
  {
    std::vector<Place> corners;
    unsigned int material;
  };

  // What goes with the number of corners of an element: its name in each format, the
  // edges that its nodes are in the middle of, and the faces S1, S2, ...
  struct Shape
  {
    std::array<unsigned int, 2> gmsh, vtk; // types of first and of second order
    std::vector<std::string> edges, edges_of_gmsh, faces;
  };

  static const Shape &shape(const std::size_t n_corners)
  {
    static const std::map<std::size_t, Shape> shapes = {
      {4,
       {{{4, 11}},
        {{10, 24}},
        {"01", "12", "20", "03", "13", "23"},
        {"01", "12", "02", "03", "23", "13"},
        {"012", "031", "132", "230"}}},
      {6,
       {{{6, 18}},
        {{13, 26}},
        {"01", "12", "20", "34", "45", "53", "03", "14", "25"},
        {"01", "02", "03", "12", "14", "25", "34", "35", "45"},
        {"012", "354", "0143", "1254", "2035"}}},
      {8,
       {{{5, 17}},
        {{12, 25}},
        {"01", "12", "23", "30", "45", "56", "67", "74", "04", "15", "26", "37"},
        {"01", "03", "04", "12", "15", "23", "26", "37", "45", "47", "56", "67"},
        {"0123", "4765", "0154", "1265", "2376", "3047"}}}};
    return shapes.at(n_corners);
  }

  void add_cube(const Place &at, const char kind)
  {
    // corners by digits in place of 0 or 1 along the axes
    static const std::map<char, std::vector<std::vector<std::string>>> cuts = {
      {'h', {{"000", "100", "110", "010", "001", "101", "111", "011"}}},
      {'z',
       {{"000", "100", "110", "001", "101", "111"},
        {"000", "110", "010", "001", "111", "011"}}},
      {'y',
       {{"000", "100", "101", "010", "110", "111"},
        {"000", "101", "001", "010", "111", "011"}}},
      {'t',
       {{"000", "100", "110", "111"},
        {"000", "100", "101", "111"},
        {"000", "010", "110", "111"},
        {"000", "010", "011", "111"},
        {"000", "001", "101", "111"},
        {"000", "001", "011", "111"}}}};
    for (const auto &cell : cuts.at(kind))
      {
        elements_.push_back({{}, at[2] == 0 ? 7U : 8U});
        for (const std::string &corner : cell)
          {
            Place place = at;
            for (unsigned int d = 0; d < 3; ++d)
              place[d] += 2 * (corner[d] - '0');
            elements_.back().corners.push_back(place);
          }
        const auto &corners = elements_.back().corners;
        for (const Place &corner : corners)
          add_node(corner);
        for (const std::string &edge : shape(corners.size()).edges)
          if (order_ == 2)
            add_node(middle(corners, edge));
        add_faces(corners);
      }
  }

  static Place middle(const std::vector<Place> &corners, const std::string &edge)
  {
    Place place{};
    for (unsigned int d = 0; d < 3; ++d)
      place[d] = (corners[edge[0] - '0'][d] + corners[edge[1] - '0'][d]) / 2;
    return place;
  }

  void add_node(const Place &place)
  {
    if (!nodes_.emplace(place, points_.size()).second)
      return;
    dealii::Point<3> p;
    for (unsigned int d = 0; d < 3; ++d)
      p[d] = place[d] / (2. * n_[d]);
    points_.push_back(map_(p));
  }

  void add_faces(const std::vector<Place> &corners)
  {
    const auto &faces = shape(corners.size()).faces;
    for (unsigned int s = 0; s < faces.size(); ++s)
      for (unsigned int side = 0; side < 6; ++side)
        if (std::all_of(faces[s].begin(), faces[s].end(), [&](const char c) {
              return corners[c - '0'][side / 2] == (side % 2 == 0 ? 0 : 2 * n_[side / 2]);
            }))
          {
            std::vector<Place> of_face;
            for (const char c : faces[s])
              of_face.push_back(corners[c - '0']);
            faces_.push_back({of_face, side});
            on_sides_[side].push_back(std::to_string(elements_.size()) + ", S" +
                                      std::to_string(s + 1));
          }
  }

  // Numbers of nodes, from 'first' on.
  std::string nodes(const Element &element, const unsigned int first,
                    const std::vector<std::string> &edges,
                    const std::string &separator) const
  {
    std::string text;
    const auto append = [&](const Place &place) {
      text += (text.empty() ? "" : separator) + std::to_string(first + nodes_.at(place));
    };
    for (const Place &corner : element.corners)
      append(corner);
    for (const std::string &edge : edges)
      if (order_ == 2)
        append(middle(element.corners, edge));
    return text;
  }

  static const std::vector<std::string> &sides()
  {
    static const std::vector<std::string> names = {"left", "right",  "front",
                                                   "back", "bottom", "top"};
    return names;
  }

  void write_gmsh(std::ostream &out) const
  {
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n8\n";
    for (unsigned int side = 0; side < 6; ++side)
      out << "2 " << side + 1 << " \"" << sides()[side] << "\"\n";
    out << "3 7 \"lower\"\n3 8 \"upper\"\n$EndPhysicalNames\n$Nodes\n"
        << points_.size() << '\n';
    for (std::size_t i = 0; i < points_.size(); ++i)
      out << i + 1 << ' ' << points_[i] << '\n';
    out << "$EndNodes\n$Elements\n" << faces_.size() + elements_.size() << '\n';
    for (const Element &face : faces_) // their corners are enough
      {
        out << "1 " << face.corners.size() - 1 << " 2 " << face.material + 1 << " 1";
        for (const Place &corner : face.corners)
          out << ' ' << nodes_.at(corner) + 1;
        out << '\n';
      }
    for (const Element &element : elements_)
      {
        const Shape &s = shape(element.corners.size());
        out << "1 " << s.gmsh[order_ - 1] << " 2 " << element.material << " 1 "
            << nodes(element, 1, s.edges_of_gmsh, " ") << '\n';
      }
    out << "$EndElements\n";
  }

  void write_abaqus(std::ostream &out) const
  {
    out << "*HEADING\n*NODE\n";
    for (std::size_t i = 0; i < points_.size(); ++i)
      out << i + 1 << ", " << points_[i][0] << ", " << points_[i][1] << ", "
          << points_[i][2] << '\n';
    for (std::size_t i = 0; i < elements_.size(); ++i)
      {
        const Shape &s        = shape(elements_[i].corners.size());
        const std::size_t n   = elements_[i].corners.size();
        const std::size_t all = n + (order_ == 2 ? s.edges.size() : 0);
        out << "*ELEMENT, TYPE=C3D" << all
            << ", ELSET=" << (elements_[i].material == 7 ? "lower" : "upper") << '\n'
            << i + 1 << ",\n"
            << nodes(elements_[i], 1, s.edges, ", ") << '\n';
      }
    for (const auto &side : on_sides_)
      {
        out << "*SURFACE, NAME=" << sides()[side.first] << '\n';
        for (const std::string &face : side.second)
          out << face << '\n';
      }
  }

  void write_vtk(std::ostream &out) const
  {
    std::vector<std::string> cells;
    std::vector<unsigned int> types, ids;
    std::size_t size = 0;
    for (const Element &element : elements_)
      {
        const Shape &s      = shape(element.corners.size());
        const std::size_t n = element.corners.size() + (order_ == 2 ? s.edges.size() : 0);
        cells.push_back(std::to_string(n) + ' ' + nodes(element, 0, s.edges, " "));
        types.push_back(s.vtk[order_ - 1]);
        ids.push_back(element.material);
        size += n + 1;
      }
    for (const Element &face : faces_)
      {
        cells.push_back(std::to_string(face.corners.size()));
        for (const Place &corner : face.corners)
          cells.back() += ' ' + std::to_string(nodes_.at(corner));
        types.push_back(face.corners.size() == 3 ? 5 : 9);
        ids.push_back(face.material + 1);
        size += face.corners.size() + 1;
      }
    out << "# vtk DataFile Version 3.0\na block\nASCII\nDATASET UNSTRUCTURED_GRID\n"
        << "POINTS " << points_.size() << " double\n";
    for (const auto &p : points_)
      out << p << '\n';
    out << "CELLS " << cells.size() << ' ' << size << '\n';
    for (const std::string &cell : cells)
      out << cell << '\n';
    out << "CELL_TYPES " << types.size() << '\n';
    for (const unsigned int type : types)
      out << type << '\n';
    out << "CELL_DATA " << ids.size()
        << "\nSCALARS MaterialID int\nLOOKUP_TABLE default\n";
    for (const unsigned int id : ids)
      out << id << '\n';
  }

  Place n_;
  Map map_;
  unsigned int order_;
  std::vector<Element> elements_, faces_; // of a face: its side, from 0
  std::map<unsigned int, std::vector<std::string>> on_sides_; // as Abaqus has them
  std::map<Place, std::size_t> nodes_;
  std::vector<dealii::Point<3>> points_;
};
