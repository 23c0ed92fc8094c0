#include <stiction/base/text/boundary_functions.h>
#include <stiction/elasticity/mesh/placed_body.h>
#include <stiction/simulation/parameters/parameters.h>

#include <sstream>

namespace stiction
{
  Parameters::Reset::Reset() { dealii::ParameterAcceptor::clear(); }

  void Parameters::read(const std::string &file, const std::vector<std::string> &settings,
                        const std::optional<std::string> &output,
                        const std::optional<std::string> &export_directory,
                        const bool has_body)
  {
    dealii::ParameterHandler &prm = dealii::ParameterAcceptor::prm;
    geometry.declare_bodies(file,
                            ParameterFile::sections(file, PlacedBody::section_name));
    source.read(file, settings, prm);
    if (output)
      source.assign("--output", "Output", "Directory", *output, prm);
    if (export_directory)
      source.assign("--export", "Output", "Export directory", *export_directory, prm);
    if (has_body)
      {
        geometry.complete(source);
        geometry.set_boundaries_in_use(boundaries_in_use());
        material.add_bodies(geometry.bodies);
      }
    contact_solver.is_automatic = contact_solver.method == "automatic";
    if (contact_solver.is_automatic)
      contact_solver.method =
        is_refused("newton multigrid", has_body) || dual_operator.form != "assembled"
          ? "newton"
          : "newton multigrid";
    if (has_body)
      check_body();
    this->output.check(source);

    time.complete();
    std::ostringstream out;
    prm.print_parameters(out, dealii::ParameterHandler::ShortPRM |
                                dealii::ParameterHandler::KeepDeclarationOrder);
    used_file_ = out.str();
  }

  std::set<std::string> Parameters::boundaries_in_use() const
  {
    std::set<std::string> names;
    for (const std::string &text : {boundary.prescribed_displacement, boundary.traction,
                                    boundary.pressure, contact.all_boundaries()})
      for (const std::string &part : split_at_bars(text))
        names.insert(split_at_colon(part).first);
    return names;
  }

  std::string Parameters::stiffness_solver_type() const
  {
    if (stiffness_solver.type != "automatic")
      return stiffness_solver.type;
    return contact_solver.is_primal() ? "multigrid" : "mumps";
  }

  std::string Parameters::default_file()
  {
    const auto printed = []() {
      std::ostringstream out;
      dealii::ParameterAcceptor::prm.print_parameters(
        out,
        dealii::ParameterHandler::PRM | dealii::ParameterHandler::KeepDeclarationOrder);
      return out.str();
    };
    const Parameters defaults;
    std::string text = printed();

    // a file with several bodies has sections that one with one body has not
    const std::string section = PlacedBody::section_name + " NAME";
    const PlacedBody body(section);
    const std::string all   = printed();
    const std::size_t begin = all.find("\nsubsection " + section + "\n") + 1;
    std::istringstream lines(all.substr(begin, all.find("\nend", begin) + 4 - begin));
    text += "\n\n# Of several bodies each has a section:\n";
    for (std::string line; std::getline(lines, line);)
      text += "# " + line + "\n";
    return text;
  }

  void Parameters::check_body() const
  {
    refinement.check(source);
    material.check(source);
    time.check(source);
    check_table_1();
    friction.check(source);
    check_method(friction.has_coulomb());
    check_solvers();
  }

  void Parameters::check_table_1() const
  {
    if (geometry.table_1_level == 0)
      return;

    source.require(geometry.has_geometric_levels(), "Geometry/Table 1 level",
                   "counts the nodes of a uniform mesh of trilinear cells, so "
                   "'Contact refinement' must be 0 and 'Element degree' 1, or this 0");

    if (contact.contact_boundary.empty())
      return; // which is missed later

    // n/m of the table come out only with the face clamped that goes with it
    const MeshNames names   = MeshNames::brick_boundaries();
    const auto displacement = parse_boundary_functions(
      boundary.prescribed_displacement,
      source.locate("Boundary conditions/Prescribed displacement"), names, 3, true);
    const unsigned int clamped = geometry.table_1_reading == "nodes" ? 2 : 0;
    source.require(displacement.size() == 1 && displacement.count(clamped) == 1 &&
                     displacement.at(clamped).components.n_selected_components() == 3 &&
                     split_at_bars(contact.contact_boundary).size() == 1 &&
                     names.id(contact.contact_boundary,
                              source.locate("Boundary conditions/Contact boundary")) == 4,
                   "Geometry/Table 1 reading",
                   "does not match the boundary conditions, this reading needs "
                   "'Prescribed displacement' on boundary " +
                     std::to_string(clamped) + " alone and 'Contact boundary = 4'");
  }

  void Parameters::check_solvers() const
  {
    source.require(contact_solver.method != "admm" || dual_operator.form == "assembled",
                   "Contact solver/Method",
                   "factorises the dual operator, so 'Dual operator/Form' must be "
                   "'assembled'");
    source.require(output.export_directory.empty() ||
                     (dual_operator.form == "assembled" && !contact_solver.is_primal()),
                   "Output/Export directory",
                   "writes the matrix Q, so 'Dual operator/Form' must be 'assembled' "
                   "and 'Contact solver/Method' another one than 'newton multigrid'");
    source.require(!contact_solver.is_primal() || stiffness_solver.type != "mumps",
                   "Stiffness solver/Type",
                   "must be 'automatic', 'multigrid' or 'amg' for 'Contact "
                   "solver/Method = newton multigrid'");
    source.require(
      !contact_solver.is_primal() || !contact.has_elastic_pairs() || is_matrix_free(),
      "Stiffness solver/Type",
      "must be 'automatic' or 'multigrid' for 'Contact solver/Method = newton "
      "multigrid' beside an obstacle 'boundary : NAME'");
    source.require(!contact_solver.is_primal() ||
                     contact_solver.coulomb_iteration == "direct",
                   "Contact solver/Coulomb iteration",
                   "must be 'direct' for 'Contact solver/Method = newton multigrid'");
    source.require(!performance.measure_factorizations || !is_matrix_free(),
                   "Performance/Measure factorizations",
                   contact_solver.is_primal()
                     ? "factorises the stiffness matrix, so 'Stiffness solver/Type' "
                       "must be 'amg'"
                     : "factorises the stiffness matrix, so 'Stiffness solver/Type' "
                       "must be 'mumps' or 'amg'");
  }

  void Parameters::check_method(const bool is_coulomb) const
  {
    source.require(
      contact_solver.method != "squares" || !is_coulomb, "Contact solver/Method",
      "is the comparison of the paper's experiment with given friction, must "
      "be another one for Coulomb friction");
  }

  bool Parameters::is_refused(const std::string &method, const bool has_body) const
  {
    if (method == "admm")
      return dual_operator.form != "assembled";
    return method == "newton multigrid" &&
           (!has_body ||
            (contact.has_elastic_pairs() && stiffness_solver.type == "amg") ||
            !output.export_directory.empty() || stiffness_solver.type == "mumps" ||
            contact_solver.coulomb_iteration != "direct" ||
            performance.measure_factorizations);
  }

  std::string Parameters::advice_on_method(const bool is_coulomb, const bool has_body,
                                           std::set<std::string> tried) const
  {
    const ContactSolverParameters &chosen = contact_solver;
    const std::string &method             = chosen.method;
    if (method == "gauss seidel" && chosen.disc_solver != "newton" &&
        chosen.disc_solver != "spectral")
      return "choose 'Contact solver/Disc solver = spectral'";
    const bool approximates = is_coulomb && chosen.coulomb_iteration == "fixed point";
    if (approximates && method != "mpgp")
      return "choose 'Contact solver/Coulomb iteration = direct'";

    // a matrix has factors, which find a way where products do not
    if (method == "newton" && dual_operator.form != "assembled")
      return "choose 'Dual operator/Form = assembled'";

    if (tried.empty())
      tried = {method};
    std::vector<std::string> others;
    for (const char *const other : {"newton", "newton multigrid", "admm", "gauss seidel"})
      if (tried.count(other) == 0 && !is_refused(other, has_body))
        others.push_back(std::string("'") +
                         (others.empty() ? "Contact solver/Method = " : "") + other +
                         "'");
    if (approximates)
      return "choose " + others[0] + " with 'Coulomb iteration = direct'";
    return "choose " + others[0] + (others.size() > 1 ? " or " + others[1] : "");
  }
} // namespace stiction
