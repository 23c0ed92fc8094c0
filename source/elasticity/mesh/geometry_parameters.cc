#include <stiction/base/errors.h>
#include <stiction/base/text/numbers.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/mesh/geometry_parameters.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  GeometryParameters::GeometryParameters()
    : ParameterAcceptor("Geometry")
  {
    add_parameter(
      "Type", type,
      "The shape of the body, with the numbers and names of its boundaries. "
      "brick: (0,Lx) x (0,Ly) x (0,Lz), 0 left: x = 0, 1 right: x = Lx, "
      "2 front: y = 0, 3 back: y = Ly, 4 bottom: z = 0, 5 top: z = Lz. "
      "cylinder: around the z axis, 0 side, 1 bottom: z = 0, 2 top: z = "
      "Length. half ball: the lower half of a ball that touches z = 0 from "
      "above, with its centre at (0, 0, Radius), 0 curved, 1 flat: the face z "
      "= Radius. generator: a mesh of deal.II's GridGenerator, boundaries "
      "have the numbers it gives them. file: a mesh from 'Mesh "
      "file'. Refined curved boundaries follow the shape, those of a file "
      "stay as the file has them. May be left out where "
      "'Lengths' or 'Table 1 level' say that it is a brick.",
      prm, Patterns::Selection("brick|cylinder|half ball|generator|file|"));
    add_parameter("Lengths", lengths,
                  "Edge lengths of the brick in x, y, z; other types ignore "
                  "it. Unit: of length. The reference brick has '4, 3, 1'.",
                  prm, Patterns::List(Patterns::Double(), 0, 3));
    add_parameter("Subdivisions", subdivisions,
                  "Number of coarse cells of the brick along x, y, z; other "
                  "types ignore it.",
                  prm, Patterns::List(Patterns::Integer(1, 100000), 0, 3));
    add_number(*this, "Radius", radius,
               "Radius of the cylinder or the half ball. Unit: of length.");
    add_number(*this, "Length", length,
               "Length of the cylinder, from z = 0; it gets coarse cells "
               "about as long as its radius. Unit: of length.");
    add_parameter(
      "Generator", generator,
      "Name of a function of deal.II's GridGenerator: one of those "
      "that make a single body of hexahedra from numbers and "
      "points.",
      prm,
      Patterns::Selection("hyper_cube|hyper_rectangle|hyper_L|hyper_ball|"
                          "hyper_ball_balanced|half_hyper_ball|quarter_hyper_ball|"
                          "hyper_shell|half_hyper_shell|quarter_hyper_shell|"
                          "cylinder|truncated_cone|"));
    add_parameter("Generator arguments", generator_arguments,
                  "Arguments of the generator after the mesh, separated by "
                  "':', points and lists by ','. The last one is often "
                  "'colorize': with 'true' the boundaries get different "
                  "numbers, as deal.II documents for each generator.",
                  prm, Patterns::Anything());
    add_parameter("Mesh file", mesh_file,
                  "The file of the mesh, looked for from the working "
                  "directory and, if it is not there, from the directory of "
                  "the parameter file: "
                  "Gmsh (.msh, version 2.2 or 4.1), Abaqus (.inp) or legacy "
                  "VTK (.vtk), as text. Cells are hexahedra with 8, 20 or "
                  "27 nodes, tetrahedra with 4 or 10, prisms with 6, 15 or 18; "
                  "tetrahedra are cut into four hexahedra each, prisms into "
                  "three. Cells of second order are cut "
                  "along their curved shape, and have it with 'Element degree = 2'. "
                  "Boundaries and materials have the numbers and names of "
                  "Gmsh's physical groups; in .inp files those of *SURFACE "
                  "and of *SOLID SECTION (else *ELSET), numbered from 1 as "
                  "they come; in .vtk files the numbers of the cell data "
                  "'MaterialID', of faces and of cells. Faces "
                  "and cells that have none get the number 0. Unit: of length.",
                  prm, Patterns::Anything());
    declare_refinement();
  }

  void GeometryParameters::declare_refinement()
  {
    add_parameter("Global refinement", global_refinement,
                  "How many times every cell is cut into eight.", prm,
                  Patterns::Integer(0, 12));
    add_parameter("Contact refinement", contact_refinement,
                  "How many more times the cells at the contact boundary and "
                  "those behind them are cut into eight, and cells around them "
                  "so that neighbours differ by one level. The nodes that hang "
                  "between small and "
                  "large cells follow their neighbours; contact is imposed at "
                  "the others.",
                  prm, Patterns::Integer(0, 6));
    add_parameter("Contact refinement where", contact_refinement_where,
                  "A formula in x, y, z: 'Contact refinement' cuts the cells "
                  "whose face on the contact boundary has its centre where "
                  "this is above 0, 'x < 1' being 1 where it holds and 0 "
                  "where it does not.",
                  prm, Patterns::Anything());
    add_parameter("Element degree", element_degree,
                  "1: trilinear displacements, 8 nodes a cell; 2: "
                  "triquadratic ones, 27 nodes. Either way contact and "
                  "friction are imposed node by node, with one contact force "
                  "a node of the contact boundary, and its pressure is the "
                  "force over the nodal area, the integral of the node's "
                  "shape function (all positive: of a face of degree 2, 1/36 "
                  "for a corner, 1/9 for an edge, 4/9 for the centre).",
                  prm, Patterns::Integer(1, 2));
    add_parameter("Table 1 level", table_1_level,
                  "Row k = 1...6 (or beyond) of Table 1 of the paper: sets "
                  "Lengths, Subdivisions and Global refinement to a mesh with "
                  "the table's numbers n/m, for the brick alone. 0: these "
                  "entries count themselves.",
                  prm, Patterns::Integer(0, 100));
    add_parameter("Table 1 reading", table_1_reading,
                  "What n/m in Table 1 counts, which the paper leaves open. "
                  "nodes: nodes and contact nodes; the 4 x 3 x 1 m brick in "
                  "(6k+2) x 6k x 2k cells, clamped at y = 0. unknowns: primal "
                  "and dual unknowns; the 3 x 1 x 1 m brick in 6k x 2k x 2k "
                  "cells, clamped at x = 0. Both readings give every row of "
                  "the table exactly.",
                  prm, Patterns::Selection("nodes|unknowns"));
  }

  double GeometryParameters::n_uniform_cells() const
  {
    double cells = std::pow(8., global_refinement);
    if (!is_brick())
      return cells;
    for (const unsigned int n : subdivisions)
      cells *= n;
    return cells;
  }

  double GeometryParameters::n_cells() const
  {
    // each local refinement makes seven more of every cell of two layers, the
    // largest there are
    const double thinnest =
      is_brick() ? *std::min_element(subdivisions.begin(), subdivisions.end()) : 1.;
    const double layer = n_uniform_cells() / std::pow(2., global_refinement) / thinnest;
    return n_uniform_cells() + 7. / 3. * std::min(2. * layer, n_uniform_cells()) *
                                 (std::pow(4., contact_refinement) - 1.);
  }

  std::string GeometryParameters::entry_of_size() const
  {
    if (!is_brick())
      return global_refinement > 0 ? "Geometry/Global refinement" : entry_of_shape();
    return table_1_level > 0                    ? "Geometry/Table 1 level"
           : n_cells() > 2. * n_uniform_cells() ? "Geometry/Contact refinement"
           : global_refinement == 0 ||
               n_uniform_cells() / std::pow(8., global_refinement) > max_cells
             ? "Geometry/Subdivisions"
             : "Geometry/Global refinement";
  }

  std::string GeometryParameters::entry_of_shape() const
  {
    return type == "file"        ? "Geometry/Mesh file"
           : type == "generator" ? "Geometry/Generator"
                                 : "Geometry/Type";
  }

  void GeometryParameters::complete(const ParameterFile &source)
  {
    location = source.describe(entry_of_shape());
    if (type == "file" && !mesh_file.empty())
      mesh_file = source.find_file("Geometry/Mesh file", mesh_file);
    // no other body has such edges or rows
    if (type.empty() && (!lengths.empty() || table_1_level > 0))
      type = "brick";
    apply_table_1_level(source);
    require_shape(source);
    check_size(source);
  }

  void GeometryParameters::apply_table_1_level(const ParameterFile &source)
  {
    const unsigned int k = table_1_level;
    if (k == 0)
      return;
    source.require(is_brick(), "Geometry/Table 1 level",
                   "is a brick, must be 0 for another 'Geometry/Type'");
    source.require(lengths.empty() && subdivisions.empty(), "Geometry/Table 1 level",
                   "says what 'Lengths' and 'Subdivisions' are, must be 0 where they "
                   "are given");
    source.require(global_refinement <= 1, "Geometry/Table 1 level",
                   "is a brick refined once, must be 0 for another 'Global refinement'");
    // refined once, so that a multigrid method finds two levels
    global_refinement = 1;
    if (table_1_reading == "nodes")
      {
        lengths      = {4., 3., 1.};
        subdivisions = {3 * k + 1, 3 * k, k};
      }
    else
      {
        lengths      = {3., 1., 1.};
        subdivisions = {3 * k, k, k};
      }
  }

  void GeometryParameters::require_shape(const ParameterFile &source) const
  {
    const auto need = [&](const bool is_said, const std::string &name,
                          const std::string &line) {
      if (!is_said)
        throw InputError(source.describe_missing("Geometry/" + name) +
                         ", write into the section 'Geometry' " + line + ".");
    };
    need(!type.empty(), "Type",
         "what the body is, 'set Type = brick', 'cylinder', 'half ball', "
         "'generator' or 'file'");
    need(type != "brick" || !lengths.empty(), "Lengths",
         "the edges of the brick, such as 'set Lengths = 4, 3, 1'");
    need(type != "brick" || !subdivisions.empty(), "Subdivisions",
         "how many cells there are along the edges, such as 'set Subdivisions "
         "= 4, 3, 1'");
    need((type != "cylinder" && type != "half ball") || radius, "Radius",
         "the radius of the " + type + ", such as 'set Radius = 1'");
    need(type != "cylinder" || length, "Length",
         "the length of the cylinder, such as 'set Length = 2'");
    need(type != "generator" || !generator.empty(), "Generator",
         "one of deal.II, such as 'set Generator = hyper_cube'");
    need(type != "generator" || !generator_arguments.empty(), "Generator arguments",
         "what GridGenerator::" + generator +
           "() has after the mesh, separated by ':', such as 'set Generator "
           "arguments = 0 : 1 : true'");
    need(type != "file" || !mesh_file.empty(), "Mesh file",
         "the file of the mesh, such as 'set Mesh file = part.msh'");
  }

  void GeometryParameters::check_size(const ParameterFile &source) const
  {
    if (is_brick())
      {
        source.require(lengths.size() == 3, "Geometry/Lengths",
                       "must be 3 entries separated by ','");
        source.require(subdivisions.size() == 3, "Geometry/Subdivisions",
                       "must be 3 entries separated by ','");
        const auto extremes   = std::minmax_element(lengths.begin(), lengths.end());
        const double shortest = *extremes.first, longest = *extremes.second;
        source.require(is_sane(shortest) && is_sane(longest), "Geometry/Lengths",
                       "each must be a number > 0, from 1e-30 to 1e30");
        source.require(longest <= 1e4 * shortest, "Geometry/Lengths",
                       "the longest may be at most 10000 times the shortest");
      }
    const bool is_cylinder = type == "cylinder";
    if (is_cylinder || type == "half ball")
      source.require(is_sane(*radius), "Geometry/Radius",
                     "must be a number > 0, from 1e-30 to 1e30");
    if (is_cylinder)
      source.require(is_sane(*length) && *length <= 1e4 * *radius &&
                       *radius <= 1e4 * *length,
                     "Geometry/Length",
                     "must be a number > 0, at most 10000 times the radius and at "
                     "least a 10000th of it");

    std::ostringstream too_many;
    too_many << "makes " << n_cells() << " cells, allowed are at most " << max_cells;
    source.require(n_cells() <= max_cells, entry_of_size(), too_many.str());
  }
} // namespace stiction
