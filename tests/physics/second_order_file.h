#pragma once

// Writes hexahedra with 20 or 27 nodes as Gmsh, Abaqus and VTK do. What a node
// is to its cell is said by its place in half edges: "210" is the middle of the
// edge from (1,0,0) to (1,1,0).

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

class SecondOrderFile
{
public:
  using Names  = std::map<std::string, unsigned int>; // of boundaries
  using Places = std::vector<std::string>;

  // The nodes are those of a triquadratic element.
  SecondOrderFile(
    const dealii::Triangulation<3> &triangulation, const Names &names,
    const dealii::Mapping<3> &mapping,
    const std::function<dealii::Point<3>(dealii::Point<3>)> &moved =
      [](dealii::Point<3> p) { return p; })
    : names_(names)
    , fe_(2)
    , dofs_(triangulation)
  {
    dofs_.distribute_dofs(fe_);
    std::map<dealii::types::global_dof_index, dealii::Point<3>> points;
    dealii::DoFTools::map_dofs_to_support_points(mapping, dofs_, points);
    for (const auto &p : points)
      points_.push_back(moved(p.second));
  }

  void write(const std::string &file, const unsigned int n) const
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ofstream out(file);
        out.precision(17);
        const std::string kind = file.substr(file.size() - 3);
        kind == "msh"   ? write_gmsh(out, n)
        : kind == "inp" ? write_abaqus(out, n)
                        : write_vtk(out, n);
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }

private:
  static Places corners()
  {
    return {"000", "200", "220", "020", "002", "202", "222", "022"};
  }

  // The edges of the bottom, of the top, the upright ones.
  static Places common_20()
  {
    Places places = corners();
    for (const char *const p : {"100", "210", "120", "010", "102", "212", "122", "012",
                                "001", "201", "221", "021"})
      places.emplace_back(p);
    return places;
  }

  static Places cut(Places places, const unsigned int n, const Places &others = {})
  {
    places.insert(places.end(), others.begin(), others.end());
    places.resize(n);
    return places;
  }

  // Of a face of deal.II, going around it.
  static Places on_face(const unsigned int face, const unsigned int n)
  {
    Places places;
    for (const std::string p : {"00", "20", "22", "02", "10", "21", "12", "01", "11"})
      {
        std::string place = p;
        place.insert(face / 2, face % 2 == 0 ? "0" : "2");
        places.push_back(place);
      }
    return cut(places, n);
  }

  // Numbers of nodes, from 'first' on.
  std::string nodes(const dealii::DoFHandler<3>::active_cell_iterator &cell,
                    const Places &places, const unsigned int first,
                    const std::string &separator) const
  {
    std::vector<dealii::types::global_dof_index> dofs(fe_.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    std::string text;
    for (const std::string &place : places)
      for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          const auto &p = fe_.unit_support_point(i);
          if (place[0] - '0' == 2 * p[0] && place[1] - '0' == 2 * p[1] &&
              place[2] - '0' == 2 * p[2])
            text += (text.empty() ? "" : separator) + std::to_string(first + dofs[i]);
        }
    return text;
  }

  template<typename Function> void for_boundary(const Function &function) const
  {
    for (const auto &cell : dofs_.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          function(cell, f, cell->face(f)->boundary_id());
  }

  unsigned int n_faces() const
  {
    unsigned int n = 0;
    for_boundary([&](const auto &, unsigned int, unsigned int) { ++n; });
    return n;
  }

  void write_gmsh(std::ostream &out, const unsigned int n) const
  {
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
        << names_.size() << '\n';
    for (const auto &name : names_)
      out << "2 " << name.second + 1 << " \"" << name.first << "\"\n";
    out << "$EndPhysicalNames\n$Nodes\n" << points_.size() << '\n';
    for (std::size_t i = 0; i < points_.size(); ++i)
      out << i + 1 << ' ' << points_[i] << '\n';
    out << "$EndNodes\n$Elements\n"
        << n_faces() + dofs_.get_triangulation().n_active_cells() << '\n';
    for_boundary([&](const auto &cell, unsigned int f, unsigned int id) {
      out << "1 " << (n == 20 ? 16 : 10) << " 2 " << id + 1 << " 1 "
          << nodes(cell, on_face(f, n == 20 ? 8 : 9), 1, " ") << '\n';
    });
    const Places places =
      cut(corners(), n,
          {"100", "010", "001", "210", "201", "120", "221", "021", "102", "012", "212",
           "122", "110", "101", "011", "211", "121", "112", "111"});
    for (const auto &cell : dofs_.active_cell_iterators())
      out << "1 " << (n == 20 ? 17 : 12) << " 2 0 1 " << nodes(cell, places, 1, " ")
          << '\n';
    out << "$EndElements\n";
  }

  void write_abaqus(std::ostream &out, const unsigned int n) const
  {
    out << "*HEADING\n*NODE\n";
    for (std::size_t i = 0; i < points_.size(); ++i)
      out << i + 1 << ", " << points_[i][0] << ", " << points_[i][1] << ", "
          << points_[i][2] << '\n';
    out << "*ELEMENT, TYPE=C3D" << n << (n == 20 ? "R" : "") << '\n';
    const Places places =
      cut(common_20(), n, {"111", "110", "112", "101", "211", "121", "011"});
    for (const auto &cell : dofs_.active_cell_iterators())
      out << cell->active_cell_index() + 1 << ",\n"
          << nodes(cell, places, 1, ", ") << '\n';
    const std::string face[] = {"S6", "S4", "S3", "S5", "S1", "S2"};
    for (const auto &name : names_)
      {
        out << "*SURFACE, NAME=" << name.first << '\n';
        for_boundary([&](const auto &cell, unsigned int f, unsigned int id) {
          if (id == name.second)
            out << cell->active_cell_index() + 1 << ", " << face[f] << '\n';
        });
      }
  }

  void write_vtk(std::ostream &out, const unsigned int n) const
  {
    const unsigned int n_cells = dofs_.get_triangulation().n_active_cells();
    const unsigned int of_face = n == 20 ? 8 : 9;
    out << "# vtk DataFile Version 3.0\nsecond order\nASCII\n"
        << "DATASET UNSTRUCTURED_GRID\nPOINTS " << points_.size() << " double\n";
    for (const auto &p : points_)
      out << p << '\n';
    out << "CELLS " << n_cells + n_faces() << ' '
        << n_cells * (n + 1) + n_faces() * (of_face + 1) << '\n';
    const Places places =
      cut(common_20(), n, {"011", "211", "101", "121", "110", "112", "111"});
    for (const auto &cell : dofs_.active_cell_iterators())
      out << n << ' ' << nodes(cell, places, 0, " ") << '\n';
    for_boundary([&](const auto &cell, unsigned int f, unsigned int) {
      out << of_face << ' ' << nodes(cell, on_face(f, of_face), 0, " ") << '\n';
    });
    out << "CELL_TYPES " << n_cells + n_faces() << '\n';
    for (unsigned int i = 0; i < n_cells; ++i)
      out << (n == 20 ? 25 : 29) << '\n';
    for (unsigned int i = 0; i < n_faces(); ++i)
      out << (n == 20 ? 23 : 28) << '\n';
    out << "CELL_DATA " << n_cells + n_faces()
        << "\nSCALARS MaterialID int\nLOOKUP_TABLE default\n";
    for (unsigned int i = 0; i < n_cells; ++i)
      out << "0\n";
    for_boundary(
      [&](const auto &, unsigned int, unsigned int id) { out << id + 1 << '\n'; });
  }

  Names names_;
  dealii::FE_Q<3> fe_;
  dealii::DoFHandler<3> dofs_;
  std::vector<dealii::Point<3>> points_;
};
