#include "faces.h"
#include "mesh_builder.h"

#include <stiction/base/errors.h>
#include <stiction/base/text/mesh_names.h>
#include <stiction/elasticity/mesh/readers/cut_into_hexahedra.h>
#include <stiction/elasticity/mesh/readers/mesh_file.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <filesystem>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    MeshData read_by_extension(const std::string &file, const std::string &location)
    {
      const std::string kind = upper(std::filesystem::path(file).extension());
      const bool is_of_cad   = kind == ".STEP" || kind == ".STP";
      if (kind != ".MSH" && kind != ".INP" && kind != ".VTK")
        throw InputError(
          location +
          ", must be a file .msh (Gmsh), .inp "
          "(Abaqus) or .vtk (VTK)" +
          (is_of_cad ? ": './run mesh " + file + " part.msh' makes one of it." : "."));
      TextScanner text(file, location);
      if (!text.is_readable())
        throw InputError(location + ", cannot be read, must be the path of a mesh file.");
      if (text.is_empty())
        throw InputError(location + ", is empty, must be a mesh file.");
      return kind == ".MSH"   ? read_gmsh(text)
             : kind == ".INP" ? read_abaqus(text)
                              : read_vtk(text);
    }

    // where it has no names
    std::string how_to_name_boundaries(const MeshData &mesh, const std::string &file)
    {
      const std::string kind = upper(std::filesystem::path(file).extension());
      const std::string way =
        kind == ".MSH"   ? "write 'Physical Surface(\"bottom\") = {...};' for each "
                           "and a 'Physical Volume' for the body before Gmsh meshes it"
        : kind == ".INP" ? "write a '*SURFACE, NAME=bottom' for each, with cells, or "
                           "sets of them, and their faces S1, S2, ..., or an '*ELSET' of "
                           "its plane elements"
                         : "write triangles or quadrilaterals of each with a number of "
                           "its own in the cell data 'MaterialID', which is what to "
                           "call it";
      if (!mesh.faces.boundary_quads.empty())
        return "its boundaries have no names; " + way;
      return std::string("the file has no ") +
             (kind == ".INP" ? "'*SURFACE' of cells and no '*ELSET' of plane elements"
                             : "surface elements") +
             ", so all of its surface is the boundary 0; " + way;
    }

    void require_cells(const MeshData &mesh, const std::string &location)
    {
      std::string others;
      bool is_solid = !mesh.cells.empty();
      for (const auto &kind : mesh.other_elements)
        {
          others +=
            (others.empty() ? "" : ", ") + std::to_string(kind.second) + " " + kind.first;
          is_solid = is_solid || kind.first == "pyramids";
        }
      if (!is_solid && (!others.empty() || !mesh.faces.boundary_quads.empty()))
        throw InputError(location + ", has faces but no cells, must be a mesh of a "
                                    "solid body, whose cells Gmsh leaves out where "
                                    "boundaries are physical groups and no 'Physical "
                                    "Volume' is one.");
      if (!is_solid)
        throw InputError(location + ", has no elements, must be a mesh of "
                                    "tetrahedra, prisms or hexahedra.");
      if (!others.empty())
        throw InputError(
          location + ", has " + others +
          ", must be of tetrahedra, prisms and hexahedra alone" +
          (others.find("of type") == std::string::npos
             ? std::string(": mesh the body with tetrahedra, or extrude all of it; "
                           "pyramids stand where quadrilaterals of recombined or "
                           "transfinite surfaces meet tetrahedra.")
             : std::string(": leave the others out; boundaries of a .inp are "
                           "'*SURFACE, NAME=bottom' with cells and their faces S1, S2, "
                           "..., or sets of elements CPS3, CPS4, CPS6 and CPS8") +
                 (others.find("M3D9") == std::string::npos
                    ? "."
                    : ", which Gmsh writes instead of M3D9 with "
                      "'Mesh.SecondOrderIncomplete = 1'.")));
    }

    // Gmsh's format 2.2 has no groups where it is told to save all elements.
    void require_groups(const MeshData &mesh, const std::string &location,
                        const std::set<std::string> &in_use)
    {
      const auto &quads = mesh.faces.boundary_quads;
      if (std::any_of(quads.begin(), quads.end(),
                      [](const CellData<2> &quad) { return quad.boundary_id != 0; }))
        return;
      for (const std::string &name : in_use)
        if (mesh.boundary_names.count(name) > 0)
          throw InputError(location + ", has no face in a group, must have those of '" +
                           name +
                           "', to which it gives a name: where Gmsh wrote it with "
                           "'Mesh.SaveAll = 1', 'Mesh.SaveAll = 0' keeps the groups.");
    }
  } // namespace

  MeshData read_mesh_file(const std::string &file, const std::string &location,
                          const std::set<std::string> &in_use)
  {
    MeshData mesh = read_by_extension(file, location);
    require_cells(mesh, location);
    require_groups(mesh, location, in_use);
    mesh.how_to_name_boundaries = how_to_name_boundaries(mesh, file);
    {
      const Faces faces(mesh, location);
      faces.require_conforming();
      faces.require_manifold();
      faces.require_unfolded();
      std::set<types::boundary_id> all, ids;
      for (const CellData<2> &quad : mesh.faces.boundary_quads)
        all.insert(quad.boundary_id);
      const MeshNames names("boundary", all, mesh.boundary_names);
      for (const std::string &name : in_use)
        if (const auto id = names.find(name))
          ids.insert(*id);
      for (std::string &what :
           faces.require_boundaries_fit(mesh.faces.boundary_quads, ids, mesh.left_out))
        mesh.damages.push_back(std::move(what));
      for (std::string &hole : faces.holes_in(mesh.faces.boundary_quads))
        mesh.damages.push_back(std::move(hole));
    }
    cut_into_hexahedra(mesh);
    GridTools::consistently_order_cells(mesh.cells);
    return mesh;
  }
} // namespace stiction
