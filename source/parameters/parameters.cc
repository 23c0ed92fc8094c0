#include <stiction/base/boundary_functions.h>
#include <stiction/base/did_you_mean.h>
#include <stiction/base/errors.h>
#include <stiction/parameters/parameters.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace stiction
{
  namespace
  {
    // Numbers near the ends of the range of a double would overflow in their
    // products; no unit system needs them.
    bool is_sane(const double value)
    {
      return value >= 1e-30 && value <= 1e30;
    }
  } // namespace

  Parameters::Reset::Reset()
  {
    dealii::ParameterAcceptor::clear();
  }

  void Parameters::read(const std::string &file, const std::vector<std::string> &settings,
                        const std::optional<std::string> &output,
                        const std::optional<std::string> &export_directory,
                        const bool has_body)
  {
    dealii::ParameterHandler &prm = dealii::ParameterAcceptor::prm;
    source.read(file, settings, prm);
    if (output)
      source.assign("--output", "Output", "Directory", *output, prm);
    if (export_directory)
      source.assign("--export", "Output", "Export directory", *export_directory, prm);
    geometry.location = source.describe(geometry.entry_of_shape());
    if (has_body)
      {
        if (geometry.type == "file" && !geometry.mesh_file.empty())
          geometry.mesh_file = source.find_file("Geometry/Mesh file", geometry.mesh_file);
        // no other body has such edges or rows
        if (geometry.type.empty() &&
            (!geometry.lengths.empty() || geometry.table_1_level > 0))
          geometry.type = "brick";
        apply_table_1_level();
        check_body();
      }
    require(!dealii::Utilities::trim(this->output.directory).empty(), "Output/Directory",
            "must name a directory");
    require(this->output.export_directory.empty() ||
              !dealii::Utilities::trim(this->output.export_directory).empty(),
            "Output/Export directory", "must name a directory or be empty");
    require(this->output.export_directory != this->output.directory,
            "Output/Export directory",
            "must be another one than 'Output/Directory', from which a later "
            "run would remove only its own files");

    std::ostringstream out;
    prm.print_parameters(out, dealii::ParameterHandler::ShortPRM |
                                dealii::ParameterHandler::KeepDeclarationOrder);
    used_file_ = out.str();
  }

  std::string Parameters::why_no_geometric_levels() const
  {
    std::string all;
    const auto add = [&](const bool holds, const std::string &reason) {
      if (holds)
        all += (all.empty() ? "" : ", ") + reason;
    };
    add(geometry.element_degree > 1, "'Element degree' 2");
    add(geometry.contact_refinement > 0, "'Contact refinement'");
    add(refinement.adaptive_steps > 0, "'Adaptive steps'");
    add(has_mean_dilatation(), "'Volume strain' cell mean");
    // the kind of a material stands after its name and a colon
    add(std::regex_search(material.materials, std::regex(":\\s*orthotropic\\s*;")),
        "an orthotropic material");
    return all;
  }

  std::string Parameters::stiffness_solver_type() const
  {
    if (stiffness_solver.type != "automatic")
      return stiffness_solver.type;
    if (!contact_solver.is_primal())
      return "mumps";
    return has_geometric_levels() && geometry.global_refinement > 0 ? "multigrid" : "amg";
  }

  bool Parameters::is_matrix_free() const
  {
    return stiffness_solver_type() == "multigrid";
  }

  bool Parameters::needs_stiffness_matrix() const
  {
    return !is_matrix_free() &&
           (!contact_solver.is_primal() || performance.measure_one_elastic_solve ||
            performance.measure_factorizations);
  }

  std::string Parameters::default_file()
  {
    const Parameters defaults;
    std::ostringstream out;
    dealii::ParameterAcceptor::prm.print_parameters(
      out,
      dealii::ParameterHandler::PRM | dealii::ParameterHandler::KeepDeclarationOrder);
    return out.str();
  }

  void Parameters::apply_table_1_level()
  {
    const unsigned int k = geometry.table_1_level;
    if (k == 0)
      return;
    require(geometry.is_brick(), "Geometry/Table 1 level",
            "is a brick, must be 0 for another 'Geometry/Type'");
    require(geometry.lengths.empty() && geometry.subdivisions.empty(),
            "Geometry/Table 1 level",
            "says what 'Lengths' and 'Subdivisions' are, must be 0 where they "
            "are given");
    require(geometry.global_refinement <= 1, "Geometry/Table 1 level",
            "is a brick refined once, must be 0 for another 'Global refinement'");
    // refined once, so that a multigrid method finds two levels
    geometry.global_refinement = 1;
    if (geometry.table_1_reading == "nodes")
      {
        geometry.lengths      = {4., 3., 1.};
        geometry.subdivisions = {3 * k + 1, 3 * k, k};
      }
    else
      {
        geometry.lengths      = {3., 1., 1.};
        geometry.subdivisions = {3 * k, k, k};
      }
  }

  void Parameters::require(const bool condition, const std::string &entry,
                           const std::string &allowed) const
  {
    if (!condition)
      throw InputError(source.describe(entry) + ", " + allowed + ".");
  }

  void Parameters::check_body() const
  {
    require_shape();
    check_geometry();
    require(is_sane(material.youngs_modulus.value_or(1.)), "Material/Young's modulus",
            "must be a number > 0, from 1e-30 to 1e30");
    const double nu = material.poisson_ratio.value_or(0.);
    require(nu > -1. && nu < 0.5, "Material/Poisson ratio",
            "must be above -1 and below 0.5");
    const double density = material.density.value_or(0.);
    require(density == 0. || is_sane(density), "Material/Density",
            "must be 0 or a number > 0, from 1e-30 to 1e30");
    require(std::abs(boundary.time) <= 1e30, "Boundary conditions/Time",
            "must be a number of at most 1e30");

    check_table_1();
    for (const std::string &law : split_at_bars(friction.law_name))
      require(friction.law_name.empty() || law == "frictionless" || law == "given" ||
                law == "coulomb",
              "Friction/Law",
              "each law must be 'frictionless', 'given' or 'coulomb'" +
                did_you_mean(law, {"frictionless", "given", "coulomb"}));
    check_method(friction.has_coulomb());
    check_solvers();
  }

  void Parameters::require_shape() const
  {
    const auto need = [&](const bool is_said, const std::string &name,
                          const std::string &line) {
      if (!is_said)
        throw InputError(source.describe_missing("Geometry/" + name) +
                         ", write into the section 'Geometry' " + line + ".");
    };
    const std::string &type = geometry.type;
    need(!type.empty(), "Type",
         "what the body is, 'set Type = brick', 'cylinder', 'half ball', "
         "'generator' or 'file'");
    need(type != "brick" || !geometry.lengths.empty(), "Lengths",
         "the edges of the brick, such as 'set Lengths = 4, 3, 1'");
    need(type != "brick" || !geometry.subdivisions.empty(), "Subdivisions",
         "how many cells there are along the edges, such as 'set Subdivisions "
         "= 4, 3, 1'");
    need((type != "cylinder" && type != "half ball") || geometry.radius, "Radius",
         "the radius of the " + type + ", such as 'set Radius = 1'");
    need(type != "cylinder" || geometry.length, "Length",
         "the length of the cylinder, such as 'set Length = 2'");
    need(type != "generator" || !geometry.generator.empty(), "Generator",
         "one of deal.II, such as 'set Generator = hyper_cube'");
    need(type != "generator" || !geometry.generator_arguments.empty(),
         "Generator arguments",
         "what GridGenerator::" + geometry.generator +
           "() has after the mesh, separated by ':', such as 'set Generator "
           "arguments = 0 : 1 : true'");
    need(type != "file" || !geometry.mesh_file.empty(), "Mesh file",
         "the file of the mesh, such as 'set Mesh file = part.msh'");
  }

  void Parameters::check_geometry() const
  {
    if (geometry.is_brick())
      {
        require(geometry.lengths.size() == 3, "Geometry/Lengths",
                "must be 3 entries separated by ','");
        require(geometry.subdivisions.size() == 3, "Geometry/Subdivisions",
                "must be 3 entries separated by ','");
        const auto extremes =
          std::minmax_element(geometry.lengths.begin(), geometry.lengths.end());
        const double shortest = *extremes.first, longest = *extremes.second;
        require(is_sane(shortest) && is_sane(longest), "Geometry/Lengths",
                "each must be a number > 0, from 1e-30 to 1e30");
        require(longest <= 1e4 * shortest, "Geometry/Lengths",
                "the longest may be at most 10000 times the shortest");
      }
    const bool is_cylinder = geometry.type == "cylinder";
    if (is_cylinder || geometry.type == "half ball")
      require(is_sane(*geometry.radius), "Geometry/Radius",
              "must be a number > 0, from 1e-30 to 1e30");
    if (is_cylinder)
      require(is_sane(*geometry.length) && *geometry.length <= 1e4 * *geometry.radius &&
                *geometry.radius <= 1e4 * *geometry.length,
              "Geometry/Length",
              "must be a number > 0, at most 10000 times the radius and at "
              "least a 10000th of it");

    require(refinement.fraction > 0. && refinement.fraction <= 1., "Refinement/Fraction",
            "must be above 0 and at most 1");

    std::ostringstream too_many;
    too_many << "makes " << geometry.n_cells() << " cells, allowed are at most "
             << GeometryParameters::max_cells;
    require(geometry.n_cells() <= GeometryParameters::max_cells, geometry.entry_of_size(),
            too_many.str());
  }

  void Parameters::check_table_1() const
  {
    if (geometry.table_1_level == 0)
      return;

    require(geometry.has_geometric_levels(), "Geometry/Table 1 level",
            "counts the nodes of a uniform mesh of trilinear cells, so "
            "'Contact refinement' must be 0 and 'Element degree' 1, or this 0");

    if (boundary.prescribed_displacement.empty() || boundary.contact_boundary.empty())
      return; // which is missed later

    // n/m of the table come out only with the face clamped that goes with it
    const MeshNames names   = MeshNames::brick_boundaries();
    const auto displacement = parse_boundary_functions(
      boundary.prescribed_displacement,
      source.locate("Boundary conditions/Prescribed displacement"), names, 3, true);
    const unsigned int clamped = geometry.table_1_reading == "nodes" ? 2 : 0;
    require(displacement.size() == 1 && displacement.count(clamped) == 1 &&
              displacement.at(clamped).components.n_selected_components() == 3 &&
              split_at_bars(boundary.contact_boundary).size() == 1 &&
              names.id(boundary.contact_boundary,
                       source.locate("Boundary conditions/Contact boundary")) == 4,
            "Geometry/Table 1 reading",
            "does not match the boundary conditions, this reading needs "
            "'Prescribed displacement' on boundary " +
              std::to_string(clamped) + " alone and 'Contact boundary = 4'");
  }

  void Parameters::check_solvers() const
  {
    require(contact_solver.method != "admm" || dual_operator.form == "assembled",
            "Contact solver/Method",
            "factorises the dual operator, so 'Dual operator/Form' must be "
            "'assembled'");
    require(output.export_directory.empty() ||
              (dual_operator.form == "assembled" && !contact_solver.is_primal()),
            "Output/Export directory",
            "writes the matrix Q, so 'Dual operator/Form' must be 'assembled' "
            "and 'Contact solver/Method' another one than 'newton multigrid'");

    require(stiffness_solver.type != "multigrid" || geometry.global_refinement > 0,
            "Stiffness solver/Type",
            "needs a coarser mesh, so 'Geometry/Global refinement' must be at "
            "least 1, or the type 'amg'");
    require(stiffness_solver.type != "multigrid" || refinement.adaptive_steps == 0,
            "Stiffness solver/Type",
            "needs cells alike on each level, so 'Refinement/Adaptive steps' "
            "must be 0, or the type 'amg'");
    require(stiffness_solver.type != "multigrid" || has_geometric_levels(),
            "Stiffness solver/Type",
            "needs trilinear cells of isotropic materials, alike on each level, so "
            "'Geometry/Contact refinement' must be 0, 'Geometry/Element "
            "degree' 1 and 'Material/Volume strain' pointwise (automatic is that up "
            "to a Poisson ratio of 0.45), or the type 'amg'");
    require(!contact_solver.is_primal() || stiffness_solver.type != "mumps",
            "Stiffness solver/Type",
            "must be 'automatic', 'multigrid' or 'amg' for 'Contact "
            "solver/Method = newton multigrid'");
    require(!contact_solver.is_primal() || contact_solver.coulomb_iteration == "direct",
            "Contact solver/Coulomb iteration",
            "must be 'direct' for 'Contact solver/Method = newton multigrid'");
    require(!performance.measure_factorizations || !is_matrix_free(),
            "Performance/Measure factorizations",
            contact_solver.is_primal()
              ? "factorises the stiffness matrix, so 'Stiffness solver/Type' "
                "must be 'amg'"
              : "factorises the stiffness matrix, so 'Stiffness solver/Type' "
                "must be 'mumps' or 'amg'");
  }

  void Parameters::check_method(const bool is_coulomb) const
  {
    if (contact_solver.method == "squares" && is_coulomb)
      throw InputError(source.describe("Contact solver/Method") +
                       ", is the comparison of the paper's experiment with "
                       "given friction, must be another one for Coulomb "
                       "friction.");
  }
} // namespace stiction
