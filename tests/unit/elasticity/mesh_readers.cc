// What mesh files may hold beside nodes and cells, and what is refused: two cubes in
// Abaqus' format and in VTK's, sets in every way that sets are written, assemblies of
// instances, data that is of no use here.

#include "tests.h"

#include <stiction/base/errors.h>
#include <stiction/elasticity/mesh/readers/mesh_file.h>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace stiction;

namespace
{
  // A line: what was read, or the sentence.
  void read(const std::string &name, const std::string &format, const std::string &text,
            const std::set<std::string> &in_use = {})
  {
    const std::string file = "mesh." + format;
    std::ofstream(file) << text;
    out() << name << ": ";
    try
      {
        const MeshData mesh = read_mesh_file(file, "The mesh", in_use);
        out() << mesh.cells.size() << " cells";
        for (const auto &[material, id] : mesh.material_names)
          {
            unsigned int n = 0;
            for (const auto &cell : mesh.cells)
              n += cell.material_id == id ? 1 : 0;
            out() << ", " << n << " of " << material;
          }
        for (const auto &[boundary, id] : mesh.boundary_names)
          {
            unsigned int n = 0;
            for (const auto &face : mesh.faces.boundary_quads)
              n += face.boundary_id == id ? 1 : 0;
            out() << ", " << n << " faces of " << boundary;
          }
        for (std::size_t b = 0; b < mesh.body_names.size(); ++b)
          if (!mesh.body_names[b].empty())
            out() << ", "
                  << std::count(mesh.body_of_cell.begin(), mesh.body_of_cell.end(), b)
                  << " of body " << mesh.body_names[b];
        for (const std::string &what : mesh.left_out)
          out() << ", without " << what;
        for (const std::string &what : mesh.damages)
          out() << ", " << what;
        if (mesh.material_names.empty())
          for (const auto &cell : mesh.cells)
            out() << ", material " << cell.material_id;
      }
    catch (const InputError &error)
      {
        out() << error.what();
      }
    out() << std::endl;
  }

  // Of the mesh that was read last, and of each of its boundaries.
  void read_box()
  {
    const MeshData mesh = read_mesh_file("mesh.inp", "The mesh", {});
    std::map<std::string, std::vector<unsigned int>> vertices;
    for (const auto &[boundary, id] : mesh.boundary_names)
      for (const auto &face : mesh.faces.boundary_quads)
        if (face.boundary_id == id)
          vertices[boundary].insert(vertices[boundary].end(), face.vertices.begin(),
                                    face.vertices.end());
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      vertices[""].push_back(v);
    const auto rounded = [](const double x) { return std::round(1e9 * x) / 1e9 + 0.; };
    for (const auto &[name, of_it] : vertices)
      {
        dealii::Point<3> low(1e9, 1e9, 1e9), high = -1. * low;
        for (const unsigned int v : of_it)
          for (unsigned int d = 0; d < 3; ++d)
            {
              low[d]  = std::min(low[d], mesh.vertices[v][d]);
              high[d] = std::max(high[d], mesh.vertices[v][d]);
            }
        out() << "  " << name << (name.empty() ? "from" : " from");
        for (unsigned int d = 0; d < 3; ++d)
          out() << ' ' << rounded(low[d]);
        out() << " to";
        for (unsigned int d = 0; d < 3; ++d)
          out() << ' ' << rounded(high[d]);
        out() << std::endl;
      }
  }

  std::string with(std::string text, const std::string &what, const std::string &by)
  {
    return text.replace(text.find(what), what.size(), by);
  }

  const std::string nodes    = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 2, 0, 0\n4, 0, 1, 0\n"
                               "5, 1, 1, 0\n6, 2, 1, 0\n7, 0, 0, 1\n8, 1, 0, 1\n"
                               "9, 2, 0, 1\n10, 0, 1, 1\n11, 1, 1, 1\n12, 2, 1, 1\n";
  const std::string elements = "*ELEMENT, TYPE=C3D8, ELSET=all\n"
                               "1, 1, 2, 5, 4, 7, 8, 11, 10\n2, 2, 3, 6, 5,\n"
                               "8, 9, 12, 11\n";
  const std::string surface  = "*SURFACE, NAME=\"the floor\"\nall, S1\n";
  const std::string abaqus = "*HEADING\ntwo cubes\n** made by hand\n" + nodes + elements;

  void abaqus_files()
  {
    const auto refused = [](const std::string &name, const std::string &what,
                            const std::string &by) {
      read(name, "inp", with(abaqus + surface, what, by));
    };
    read("as it is", "inp", abaqus + surface);
    read("generated sets", "inp",
         abaqus +
           "*ELSET, ELSET=one, GENERATE\n1, 1\n*Elset, elset=two, generate\n2, 2, 1\n"
           "*SOLID SECTION, ELSET=one, MATERIAL=steel\n"
           "*SOLID SECTION, ELSET=two, MATERIAL=rubber\n*SURFACE, NAME=floor\n"
           "1, S1\ntwo, S1\n");
    read("sets of sets", "inp",
         abaqus + "*ELSET, ELSET=first\n1,\n*ELSET, ELSET=both\nFIRST, 2\n"
                  "*SURFACE, NAME=floor\nboth, s1\n");
    read("surfaces of nodes are passed over", "inp",
         abaqus + surface + "*SURFACE, NAME=n, TYPE=NODE\n1, 1.\n");
    read("so are those of other surfaces", "inp",
         abaqus + surface + "*SURFACE, NAME=both, COMBINE=UNION\nthe floor, skin\n");
    const std::string on_two =
      abaqus + "*SURFACE, NAME=skin\nall, S1\nall, S2\n" + surface;
    read("a face on two boundaries", "inp", on_two);
    read("of which the first is used", "inp", on_two, {"skin"});
    read("the second", "inp", on_two, {"the floor", "roof"});
    read("by its number", "inp", on_two, {"2"});
    read("both", "inp", on_two, {"the floor", "skin"});
    const std::string plane = "*ELEMENT, TYPE=CPS4, ELSET=Surface1\n11, 1, 2, 5, 4\n"
                              "12, 2, 3, 6, 5\n";
    read("plane elements, as Gmsh writes faces", "inp", abaqus + plane);
    read("by another set of them", "inp", abaqus + plane + "*ELSET, ELSET=floor\n11,12\n",
         {"floor"});
    read("and by a surface of that name", "inp",
         abaqus + plane + "*ELSET, ELSET=floor\n12\n*SURFACE, NAME=floor\n1, S1\n",
         {"floor"});
    read("a set that stands before them", "inp",
         abaqus + "*ELSET, ELSET=floor\n11, 12\n" + with(plane, ", ELSET=Surface1", ""));
    read("a generated one", "inp",
         abaqus + "*ELSET, ELSET=floor, GENERATE\n11, 12\n" +
           with(plane, ", ELSET=Surface1", ""));
    read("sets of sets that stand behind", "inp",
         abaqus + "*ELSET, ELSET=floor\nboth, 11\n*ELSET, ELSET=both\nSURFACE1, floor\n" +
           plane + "*SURFACE, NAME=all faces\nBOTH2, S1\n*ELSET, ELSET=both2\nall\n",
         {"floor"});
    read("a set of a set that is nowhere", "inp",
         abaqus + "*ELSET, ELSET=floor\n11, flor\n" + plane);
    read("names in other capital letters", "inp",
         abaqus + plane + "*ELSET, ELSET=SURFACE1\n11\n*ELSET, ELSET=FLOOR\n12\n" +
           "*SURFACE, NAME=Floor\n1, S1\n",
         {"Floor"});
    read("surfaces in other capital letters", "inp",
         abaqus + surface + with(surface, "the floor", "The Floor"));
    read("a surface of them", "inp",
         abaqus + plane + "*SURFACE, NAME=floor\nSurface1, S1\n");
    read("of one of them", "inp", abaqus + plane + "*SURFACE, NAME=floor\n11, S1\n");
    read("of one that is not there", "inp",
         abaqus + "*ELSET, ELSET=set\n1, 7\n*SURFACE, NAME=floor\nset, S1\n");
    read("one twice", "inp", abaqus + plane + "11, 1, 2, 5, 4\n");
    read("of second order", "inp",
         "*NODE\n1, 0, 0, 0\n2, 2, 0, 0\n3, 0, 2, 0\n4, 0, 0, 2\n5, 1, 0, 0\n6, 1, 1, "
         "0\n7, 0, 1, 0\n8, 0, 0, 1\n9, 1, 0, 1\n10, 0, 1, 1\n*ELEMENT, TYPE=CPS6, "
         "ELSET=floor\n1, 1, 3, 2, 7, 6, 5\n*ELEMENT, TYPE=C3D10, ELSET=all\n2, 1, 2, 3, "
         "4, 5, 6, 7, 8, 9, 10\n");
    read("with too few nodes", "inp", abaqus + with(plane, "CPS4", "CPS8"));
    refused("included", "*HEADING", "*INCLUDE, INPUT=other.inp");
    refused("nodes elsewhere", "*NODE", "*NODE, INPUT=other.inp");
    refused("no keyword", "*HEADING\n", "");
    refused("a node without z", "3, 2, 0, 0", "3, 2, 0");
    refused("a node twice", "3, 2, 0, 0", "2, 2, 0, 0");
    refused("an element twice", "2, 2, 3, 6, 5", "1, 2, 3, 6, 5");
    refused("an element without a node", "8, 9, 12, 11", "8, 9, 12, 13");
    refused("an incomplete element", "8, 9, 12, 11", "8, 9, 12,");
    refused("seven nodes", "8, 9, 12, 11", "8, 9, 12");
    refused("unknown elements", "C3D8", "C3D9");
    refused("no part of a surface", "all, S1", "all, S1, S2");
    refused("no face", "all, S1", "all, S7");
    refused("no set", "all, S1", "none, S1");
    refused("no element", "all, S1", "7, S1");
    refused("an exponent of Fortran", "3, 2, 0, 0", "3, 0.2D1, 0.d0, 0D+00");
    refused("two exponents", "3, 2, 0, 0", "3, 0.2D1D1, 0, 0");
    read("a set that is written wrong", "inp",
         abaqus + "*SURFACE, NAME=a\nal, S1\n" + surface);
    read("a set without name", "inp", abaqus + "*ELSET\n1\n");
    read("a set of one number", "inp", abaqus + "*ELSET, ELSET=a, GENERATE\n1\n");
    read("a set that falls", "inp", abaqus + "*ELSET, ELSET=a, GENERATE\n1, 9, -1\n");
    read("a set too large", "inp", abaqus + "*ELSET, ELSET=a, GENERATE\n1, 99999999\n");
    read("two materials of an element", "inp",
         abaqus + "*ELSET, ELSET=a\n1\n*SOLID SECTION, ELSET=a, MATERIAL=steel\n"
                  "*SOLID SECTION, ELSET=all, MATERIAL=rubber\n");
    read("a face that a tetrahedron lacks", "inp",
         nodes + "*ELEMENT, TYPE=C3D4, ELSET=all\n1, 1, 2, 4, 7\n*SURFACE, NAME=a\n"
                 "all, S5\n");
  }

  // The box of all vertices, too: a part twice, moved by 5 along x and turned by 90
  // degrees about the axis along z through (5, 0, 0); numbers of elements in the
  // assembly, sets in a part; the mesh in the instance; parts without instances.
  void abaqus_assemblies()
  {
    const std::string surface_of_part = "*SURFACE, NAME=floor\nall, S1\n";
    const auto part                   = [&](const std::string &name) {
      return "*PART, NAME=" + name + "\n" + nodes + elements + surface_of_part +
             "*END PART\n";
    };
    const auto instance = [](const std::string &name, const std::string &lines = "",
                             const std::string &of = "p") {
      return "*INSTANCE, NAME=" + name + ", PART=" + of + "\n" + lines +
             "*END INSTANCE\n";
    };
    const std::string moved = "5., 0., 0.\n", turned = "5, 0, 0, 5, 0, 2, 90\n";
    read("an instance", "inp", part("p") + instance("one"));
    read_box();
    read("an instance that is moved", "inp", part("p") + instance("one", moved));
    read_box();
    read("two instances", "inp",
         part("p") + instance("one") + instance("two", moved + turned) +
           "*ELSET, ELSET=end, INSTANCE=two\n2,\n*SURFACE, NAME=ceiling\nend, S2\n"
           "one.all, S2\n");
    read_box();
    // where there is one instance, names and numbers count as well without its name
    const std::string whole = part("p") + instance("one", moved);
    read("sets of one name", "inp",
         with(whole, "*SURFACE, NAME=floor\nall, S1",
              "*ELSET, ELSET=s\n1,\n*SURFACE, "
              "NAME=floor\ns, S1") +
           "*ELSET, ELSET=s, INSTANCE=one\n2,\n*SURFACE, NAME=ceiling\ns, S2\n");
    read("surfaces of one name", "inp", whole + "*SURFACE, NAME=floor\none.all, S2\n");
    read("a node of the assembly", "inp",
         whole + "*NODE\n1, 9., 9., 9.\n*SURFACE, NAME=ceiling\none.2, S2\n1, S2\n");
    read("lines that go on", "inp",
         part("p") + "*Instance, name=\"one\",\nPart=p\n,,1.\n*EndInstance\n"
                     "*SURFACE, NAME=ceiling\n\"one.all\", S2\n");
    read_box();
    read("a set of another instance", "inp",
         part("p") + instance("one") + instance("two", moved) +
           "*ELSET, ELSET=x, INSTANCE=one\n1,\n*ELSET, ELSET=y, INSTANCE=two\nx,\n");
    read("of another analysis", "inp", part("p") + "*INSTANCE, INSTANCE=one\n");
    read("no name", "inp", part("p") + instance(""));
    read("a comment that ends with a comma", "inp",
         with(whole, "*END PART", "** nodes, elements,\n*END PART"));
    read("a part that does not end", "inp", with(whole, "*END PART", "*ENDE"));
    read("a rotation alone", "inp", part("p") + instance("one", turned));
    read("cylindrical", "inp", with(whole, "*NODE", "*NODE, SYSTEM=C"));
    read("generated", "inp", with(whole, "*SURFACE", "*NGEN\n1, 2\n*SURFACE"));
    read("a mesh in the instance", "inp",
         "*PART, NAME=p\n*END PART\n" + instance("one", nodes + elements) +
           instance("two", moved + nodes + elements));
    read_box();
    read("two parts", "inp", part("p") + with(part("q"), "1, 0, 0, 0", "1, -1, 0, 0"));
    read("no part", "inp", part("p") + instance("one", moved, "q"));
    read("no instance", "inp",
         part("p") + instance("one") + instance("two", moved) +
           "*ELSET, ELSET=end, INSTANCE=three\n2,\n");
    read("an instance twice", "inp", part("p") + instance("one") + instance("one"));
    read("a part twice", "inp", part("p") + part("p"));
    read("four numbers", "inp", part("p") + instance("one", "1, 2, 3, 4\n"));
    read("no axis", "inp", part("p") + instance("one", moved + "1, 1, 1, 1, 1, 1, 90\n"));
  }

  // The bottom of 4 x 4 x 1 cells without some of its faces, of cells or of prisms.
  void abaqus_holes()
  {
    std::string cells = "*NODE\n", prisms;
    for (unsigned int n = 0; n < 50; ++n)
      cells += std::to_string(n + 1) + ", " + std::to_string(n % 5) + ", " +
               std::to_string(n / 5 % 5) + ", " + std::to_string(n / 25) + '\n';
    prisms = cells += "*ELEMENT, TYPE=";
    cells += "C3D8, ELSET=all\n";
    prisms += "C3D6, ELSET=all\n";
    for (unsigned int e = 0; e < 16; ++e)
      {
        const auto add = [&](std::string &to, const unsigned int number,
                             const std::vector<unsigned int> &corners) {
          to += std::to_string(number);
          for (const unsigned int layer : {0, 25})
            for (const unsigned int corner : corners)
              to += ", " + std::to_string(5 * (e / 4) + e % 4 + corner + layer);
          to += '\n';
        };
        add(cells, e + 1, {1, 2, 7, 6});
        add(prisms, 2 * e + 1, {1, 2, 7});
        add(prisms, 2 * e + 2, {1, 7, 6});
      }
    const auto without = [](const std::string &name, const std::string &elements,
                            const unsigned int n, const std::set<unsigned int> &missing) {
      std::string text = elements + "*SURFACE, NAME=floor\n";
      for (unsigned int e = 1; e <= n; ++e)
        if (missing.count(e) == 0)
          text += std::to_string(e) + ", S1\n";
      read(name, "inp", text + "*SOLID SECTION, ELSET=all, MATERIAL=steel\n");
    };
    without("all faces", cells, 16, {});
    without("one missing inside", cells, 16, {6});
    without("one at an edge, two in all", cells, 16, {2, 16});
    without("a square left out", cells, 16, {6, 7, 10, 11});
    without("a strip left out", cells, 16, {5, 6, 7, 8});
    without("half of it left out", cells, 16, {1, 2, 3, 4, 5, 6, 7, 8});
    without("all triangles", prisms, 32, {});
    without("two missing inside, and two that are neighbours", prisms, 32,
            {11, 22, 27, 28});
    without("a square of triangles left out", prisms, 32,
            {11, 12, 13, 14, 19, 20, 21, 22});
  }

  const std::string points    = "# vtk DataFile Version 3.0\ntwo cubes\nASCII\n"
                                "DATASET UNSTRUCTURED_GRID\nPOINTS 12 double\n0 0 0 1 0 0\n"
                                "2 0 0 0 1 0\n1 1 0 2 1 0\n0 0 1 1 0 1\n2 0 1 0 1 1 1 1 1\n"
                                "2 1 1\n";
  const std::string cells     = "CELLS 2 18\n8 0 1 4 3 6 7 10 9\n8 1 2 5 4 7 8 11 10\n"
                                "CELL_TYPES 2\n12 12\n";
  const std::string materials = "CELL_DATA 2\nSCALARS MaterialID int 1\n"
                                "LOOKUP_TABLE default\n3 4\n";

  void vtk_files()
  {
    const auto refused = [](const std::string &name, const std::string &what,
                            const std::string &by) {
      read(name, "vtk", with(points + cells + materials, what, by));
    };
    const auto with_data = [](const std::string &name, const std::string &data) {
      read(name, "vtk", points + cells + data + materials);
    };
    const auto with_offsets = [](const std::string &name, const std::string &size,
                                 const std::string &offsets) {
      read(name, "vtk",
           points + "CELLS 3 " + size + "\nOFFSETS vtktypeint64\n" + offsets +
             "\nCONNECTIVITY vtktypeint64\n0 1 4 3 6 7 10 9\n1 2 5 4 7 8 11 10\n"
             "CELL_TYPES 2\n12 12\n");
    };
    read("as it is", "vtk", points + cells + materials);
    read("without numbers", "vtk", points + cells);
    with_data("metadata", "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtk\n\n");
    std::string vectors, tensors;
    for (unsigned int i = 0; i < 12; ++i)
      {
        vectors += "0 0 1\n";
        tensors += "1 0 0 0 1 0 0 0 1\n";
      }
    with_data("vectors and tensors", "POINT_DATA 12\nVECTORS u double\n" + vectors +
                                       "NORMALS n double\n" + vectors +
                                       "TENSORS s double\n" + tensors);
    with_data("colours", "LOOKUP_TABLE table 2\n0 0 0 1\n1 1 1 1\n");
    with_data(
      "a field",
      "POINT_DATA 12\nFIELD FieldData 1\nT 1 12 double\n1 2 3 4 5 6 7 8 9 0 1 2\n");
    with_offsets("offsets, as version 5.1 has them", "16", "0 8 16");
    with_data(
      "a field of strings",
      "POINT_DATA 12\nFIELD FieldData 1\nT 1 12 string\na b c d e f g h i j k l\n");
    refused("binary", "ASCII", "BINARY");
    refused("another data set", "UNSTRUCTURED_GRID", "POLYDATA");
    refused("no table", "LOOKUP_TABLE default\n", "");
    refused("an unknown section", "CELL_TYPES", "CELL_KINDS");
    refused("fewer types", "CELL_TYPES 2\n12 12", "CELL_TYPES 1\n12");
    refused("a voxel", "12 12", "12 11");
    with_offsets("offsets that fall", "16", "0 8 4");
    with_offsets("too few numbers for the offsets", "15", "0 8 16");
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  out() << "Abaqus" << std::endl;
  abaqus_files();
  out() << "Abaqus, parts and instances" << std::endl;
  abaqus_assemblies();
  out() << "Abaqus, holes in boundaries" << std::endl;
  abaqus_holes();
  out() << "VTK" << std::endl;
  vtk_files();
}
