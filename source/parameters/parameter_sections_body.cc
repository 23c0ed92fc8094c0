#include <stiction/base/boundary_functions.h>
#include <stiction/parameters/parameters.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    // Declares an entry that is a number or empty: not said.
    void add_number(dealii::ParameterAcceptor &section, const std::string &name,
                    std::optional<double> &number, const std::string &documentation)
    {
      dealii::ParameterHandler &prm = dealii::ParameterAcceptor::prm;
      section.enter_my_subsection(prm);
      prm.declare_entry(name, "", Patterns::List(Patterns::Double(), 0, 1),
                        documentation);
      prm.add_action(name, [&number](const std::string &text) {
        if (text.empty())
          number.reset();
        else
          number = dealii::Utilities::string_to_double(text);
      });
      section.leave_my_subsection(prm);
    }
  } // namespace

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
      "have the numbers it gives them. file: a mesh of hexahedra from 'Mesh "
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
                  "VTK (.vtk), as text. Cells must be hexahedra with 8, 20 or "
                  "27 nodes; those of second order are cut along their curved "
                  "shape, and have it with 'Element degree = 2'. "
                  "Boundaries and materials have the numbers and names of "
                  "Gmsh's physical groups; in .inp files those of *SURFACE "
                  "and of *SOLID SECTION (else *ELSET), numbered from 1 as "
                  "they come; in .vtk files the numbers of the cell data "
                  "'MaterialID', of quadrilaterals and of hexahedra. Faces "
                  "and cells that have none get the number 0. Unit: of length.",
                  prm, Patterns::Anything());
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

  MaterialParameters::MaterialParameters()
    : ParameterAcceptor("Material")
  {
    add_number(*this, "Young's modulus", youngs_modulus,
               "E of the isotropic linear elastic body, > 0; must be said "
               "unless 'Materials' says what all cells are made of. Unit: of stress. "
               "The steel of the reference brick has 2.119e11.");
    add_number(*this, "Poisson ratio", poisson_ratio,
               "nu, above -1 and below 0.5; must be said with Young's modulus. "
               "Above 0.45 see 'Volume strain'.");
    add_number(*this, "Density", density,
               "Mass density, >= 0, of which 'Boundary conditions/Gravity' "
               "makes weight; must be said with it, here or in 'Densities'. "
               "Unit: of mass per volume.");
    add_parameter("Materials", materials,
                  "Materials other than the one above, by the id or name they "
                  "have in the mesh: 'material : isotropic; E; nu' or 'material "
                  ": orthotropic; E1; E2; E3; nu12; nu13; nu23; G12; G13; G23' "
                  "with the axes x, y, z, nu12 being the contraction along y "
                  "under a pull along x, several separated by '|'. Cells of any "
                  "other material have the numbers above.",
                  prm, Patterns::Anything());
    add_parameter(
      "Volume strain", volume_strain,
      "pointwise: as the displacements have it; trilinear elements "
      "then lock as nu approaches 0.5, bodies and forces become many times too "
      "stiff. cell mean: the change of volume is the same all over a cell "
      "(mean dilatation, B-bar), for nearly incompressible materials; with an "
      "assembled stiffness matrix, without geometric multigrid. automatic: "
      "cell mean for trilinear elements if an isotropic material has nu above "
      "0.45, otherwise pointwise.",
      prm, Patterns::Selection("automatic|pointwise|cell mean"));
    add_parameter("Densities", densities,
                  "Mass densities other than the one above: 'material : "
                  "density', several separated by '|'. Unit: of mass per volume.",
                  prm, Patterns::Anything());
    add_parameter("Material ids", material_ids,
                  "Which material is where, as a formula in x, y, z, t: its "
                  "value at the centre of a coarse cell, an integer from 0 to "
                  "1000, is the material id of that cell, 'if(z < 0.5, 0, 1)' "
                  "makes two layers. Empty: the ids that the mesh has; all "
                  "cells of a brick have 0.",
                  prm, Patterns::Anything());
  }

  double MaterialParameters::largest_poisson_ratio() const
  {
    double largest = poisson_ratio.value_or(-1.);
    // what is not to be read is refused where the materials are made
    for (const std::string &material : split_at_bars(materials))
      {
        const auto words = dealii::Utilities::split_string_list(
          material.substr(material.find(':') + 1), ";"); // none: all of it
        if (words.size() == 3 && words[0] == "isotropic")
          largest = std::max(largest, std::strtod(words[2].c_str(), nullptr));
      }
    return largest;
  }

  bool MaterialParameters::has_mean_dilatation(const unsigned int element_degree) const
  {
    return volume_strain == "cell mean" ||
           (volume_strain == "automatic" && element_degree == 1 &&
            largest_poisson_ratio() > locking_poisson_ratio);
  }

  RefinementParameters::RefinementParameters()
    : ParameterAcceptor("Refinement")
  {
    add_parameter("Adaptive steps", adaptive_steps,
                  "How many times the mesh is refined where the solution needs "
                  "it: the problem is solved and certified, the error is "
                  "estimated cell by cell (in the energy norm, from what the "
                  "stress lacks to be in equilibrium inside the cells, across "
                  "their faces and with the loads and contact forces), the "
                  "cells with the largest errors are cut into eight, and the "
                  "problem is solved again. The files are those of the last "
                  "mesh; it is the last one too if its answer is not "
                  "certified.",
                  prm, Patterns::Integer(0, 50));
    add_parameter("Fraction", fraction,
                  "The cells that are cut are the fewest that make up this "
                  "part of the sum of the squares of the estimated errors; "
                  "above 0, at most 1.",
                  prm, Patterns::Double());
    add_parameter("Maximum unknowns", maximum_unknowns,
                  "No mesh is made that would have more unknowns than about "
                  "this; 0: the memory is the limit.",
                  prm, Patterns::Integer(0));
    add_parameter("Estimate error", estimate_error,
                  "Whether the last lines of a run say how large the error of "
                  "the mesh is, as a part of the energy norm of the "
                  "displacement: an estimate, no bound. Above 16384 cells it "
                  "is made from a sample of them. Adaptive steps estimate it "
                  "in any case.",
                  prm, Patterns::Bool());
  }
} // namespace stiction
