#include <stiction/base/errors.h>
#include <stiction/base/text/numbers.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/mesh/shape_parameters.h>

#include <algorithm>
#include <map>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    const std::string ball  = "center : radius",
                      shell = "center : inner_radius : outer_radius : n_cells : colorize",
                      box   = "left : right : colorize";

    // deal.II's generators and what they have after the mesh.
    const std::map<std::string, std::string> generators = {
      {"hyper_cube", box},
      {"hyper_rectangle", "p1 : p2 : colorize"},
      {"hyper_L", box},
      {"hyper_ball", ball + " : attach_spherical_manifold"},
      {"hyper_ball_balanced", ball},
      {"half_hyper_ball", ball},
      {"quarter_hyper_ball", ball},
      {"hyper_shell", shell},
      {"half_hyper_shell", shell},
      {"quarter_hyper_shell", shell},
      {"cylinder", "radius : half_length"},
      {"truncated_cone", "radius_0 : radius_1 : half_length"}};

    std::string all_generators(const std::string &separator, const bool with_arguments)
    {
      std::string all;
      for (const auto &[name, arguments] : generators)
        all += (all.empty() ? "" : separator) + name +
               (with_arguments ? " (" + arguments + ")" : "");
      return all;
    }
  } // namespace

  ShapeParameters::ShapeParameters(const std::string &section)
    : ParameterAcceptor(section)
    , location(section)
    , section_(section)
  {
    add_parameter(
      "Type", type,
      "The shape of the body, with the numbers and names of its boundaries. brick: "
      "(0,Lx) x (0,Ly) x (0,Lz), 0 left: x = 0, 1 right: x = Lx, 2 front: y = 0, 3 back: "
      "y = Ly, 4 bottom: z = 0, 5 top: z = Lz. cylinder: around the z axis, 0 side, 1 "
      "bottom: z = 0, 2 top: z = Length, with 'Inner radius' a tube, 3 inside. half "
      "ball: the lower half of a ball that touches z = 0 from above, with its centre at "
      "(0, 0, Radius), 0 curved, 1 flat: the face z = Radius. generator: a mesh of "
      "deal.II's GridGenerator, boundaries have the numbers it gives them. file: a mesh "
      "from 'Mesh file'. Refined curved boundaries follow the shape, those of a file "
      "stay as the file has them. May be left out where 'Lengths' or 'Table 1 level' say "
      "that it is a brick, or 'Mesh file' that it is a file. Several bodies have in "
      "place of it a section each, 'subsection Body NAME', with the entries from Type to "
      "Mesh file and Refinement, Translation, Rotation, Young's modulus, Poisson ratio, "
      "Density; their boundaries are called 'NAME.bottom' then.",
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
    add_number(*this, "Inner radius", inner_radius,
               "Of the hole along the axis of the cylinder, none if it is not set. "
               "Coarse cells go through the wall and are about as wide and long as it is "
               "thick, but there are from 8 to 48 around the axis. Unit: of length.");
    add_number(
      *this, "Length", length,
      "Length of the cylinder, from z = 0; it gets coarse cells "
      "about as long as its radius, or as wide ones of a tube. Unit: of length.");
    add_parameter("Generator", generator,
                  "Name of a function of deal.II's GridGenerator: one of those that make "
                  "a single body of hexahedra from numbers and points, " +
                    all_generators(", ", true) + ".",
                  prm, Patterns::Selection(all_generators("|", false) + "|"));
    add_parameter("Generator arguments", generator_arguments,
                  "All arguments of the generator, separated by ':', such as '0, 0, 0 : "
                  "1 : 2 : 6 : true' of a shell; center, p1 and p2 are points. With "
                  "colorize = true boundaries get different "
                  "numbers, as deal.II documents for each generator.");
    add_parameter("Mesh file", mesh_file,
                  "The file of the mesh, looked for beside the parameter file and, if "
                  "it is not there, from the working directory: Gmsh "
                  "(.msh, version 2.2 or 4.1), Abaqus (.inp) or legacy VTK (.vtk), as "
                  "text. Cells are hexahedra with 8, 20 or 27 nodes, tetrahedra with 4 "
                  "or 10, prisms with 6, 15 or 18; tetrahedra are cut into four "
                  "hexahedra each, prisms into three. Cells of second order are cut "
                  "along their curved shape, and have it with 'Element degree = 2'. "
                  "Boundaries and materials have the numbers and names of Gmsh's "
                  "physical groups; in .inp files those of *SURFACE, then of sets of "
                  "plane elements (CPS3 to CPS8, as Gmsh writes faces), and of *SOLID "
                  "SECTION (else *ELSET), numbered from 1 as they come, boundaries and "
                  "sets of a part as INSTANCE.NAME where there are several instances, "
                  "loads, supports and laws passed over; in .vtk files the numbers of "
                  "the cell data 'MaterialID', of faces and of cells. Faces and cells "
                  "that have none get the number 0; faces of several boundaries count "
                  "for the one that other entries speak of, which may be one alone. "
                  "Unit: of length.");
  }

  std::string ShapeParameters::entry_of_shape() const
  {
    return type == "file"        ? entry("Mesh file")
           : type == "generator" ? entry("Generator")
           : is_brick()          ? entry("Lengths")
                                 : entry("Type");
  }

  std::string ShapeParameters::generator_takes() const
  {
    const auto found = generators.find(generator);
    return found == generators.end() ? "" : found->second;
  }

  double ShapeParameters::n_coarse_cells() const
  {
    double cells = 1.;
    if (is_brick())
      for (const unsigned int n : subdivisions)
        cells *= n;
    return cells;
  }

  double ShapeParameters::n_thinnest() const
  {
    return is_brick() && !subdivisions.empty()
             ? *std::min_element(subdivisions.begin(), subdivisions.end())
             : 1.;
  }

  void ShapeParameters::locate(const ParameterFile &source)
  {
    source.require(!type.empty() || lengths.empty() || mesh_file.empty(),
                   entry("Mesh file"),
                   "says what the body is, as 'Lengths' do too, must be the only one of "
                   "the two, or 'Type' must say which of them counts");
    // no other body has such edges
    if (type.empty() && !lengths.empty())
      type = "brick";
    if (type.empty() && !mesh_file.empty())
      type = "file";
    location = source.describe(entry_of_shape());
    if (type == "file" && !mesh_file.empty())
      mesh_file = source.find_file(entry("Mesh file"), mesh_file);
  }

  void ShapeParameters::check(const ParameterFile &source) const
  {
    require_shape(source);
    if (is_brick())
      {
        source.require(lengths.size() == 3, entry("Lengths"),
                       "must be 3 entries separated by ','");
        source.require(subdivisions.size() == 3, entry("Subdivisions"),
                       "must be 3 entries separated by ','");
        const auto extremes   = std::minmax_element(lengths.begin(), lengths.end());
        const double shortest = *extremes.first, longest = *extremes.second;
        source.require(is_sane(shortest) && is_sane(longest), entry("Lengths"),
                       "each must be " + sane_number);
        source.require(longest <= 1e4 * shortest, entry("Lengths"),
                       "the longest may be at most 10000 times the shortest");
      }
    const bool is_cylinder = type == "cylinder";
    if (is_cylinder || type == "half ball")
      source.require(is_sane(*radius), entry("Radius"), "must be " + sane_number);
    if (is_cylinder)
      source.require(is_sane(*length) && *length <= 1e4 * *radius &&
                       *radius <= 1e4 * *length,
                     entry("Length"),
                     "must be a number > 0, at most 10000 times the radius and at "
                     "least a 10000th of it");
    source.require(!inner_radius || is_cylinder, entry("Inner radius"),
                   "is that of a cylinder, must not be there with other types");
    source.require(!inner_radius || (*inner_radius >= 1e-3 * *radius &&
                                     *inner_radius <= 0.999 * *radius),
                   entry("Inner radius"),
                   "must be from a thousandth of 'Radius' to 0.999 times it");
  }

  void ShapeParameters::require_shape(const ParameterFile &source) const
  {
    const auto need = [&](const bool is_said, const std::string &name,
                          const std::string &line) {
      if (!is_said)
        throw InputError(source.describe_missing(entry(name)) +
                         ", write into the section '" + section_ + "' " + line + ".");
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
         "its arguments, 'set Generator arguments = " + generator_takes() + "'");
    need(type != "file" || !mesh_file.empty(), "Mesh file",
         "the file of the mesh, such as 'set Mesh file = part.msh'");
  }
} // namespace stiction
