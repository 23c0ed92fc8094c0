#include <stiction/elasticity/boundary_functions.h>
#include <stiction/errors.h>
#include <stiction/parameters.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    // Unknowns are numbered with 32 bits, in Trilinos and in MUMPS.
    constexpr double max_cells = 4e8;
  } // namespace

  GeometryParameters::GeometryParameters()
    : ParameterAcceptor("Geometry")
  {
    add_parameter("Type",
                  type,
                  "The shape of the body. brick: (0,Lx) x (0,Ly) x (0,Lz). Its "
                  "faces have the boundary ids 0: x = 0, 1: x = Lx, 2: y = 0, "
                  "3: y = Ly, 4: z = 0, 5: z = Lz.",
                  prm,
                  Patterns::Selection("brick"));
    add_parameter("Lengths",
                  lengths,
                  "Edge lengths in x, y, z. Unit: m. The default is the "
                  "reference brick.",
                  prm,
                  Patterns::List(Patterns::Double(), 3, 3));
    add_parameter("Subdivisions",
                  subdivisions,
                  "Number of coarse cells along x, y, z.",
                  prm,
                  Patterns::List(Patterns::Integer(1, 100000), 3, 3));
    add_parameter("Global refinement",
                  global_refinement,
                  "How many times every cell is cut into eight.",
                  prm,
                  Patterns::Integer(0, 12));
    add_parameter("Table 1 level",
                  table_1_level,
                  "Row k = 1...6 (or beyond) of Table 1 of the paper: sets "
                  "Lengths, Subdivisions and Global refinement to a mesh with "
                  "the table's numbers n/m. 0: the three entries above count.",
                  prm,
                  Patterns::Integer(0, 100));
    add_parameter("Table 1 reading",
                  table_1_reading,
                  "What n/m in Table 1 counts, which the paper leaves open. "
                  "nodes: nodes and contact nodes; the 4 x 3 x 1 m brick in "
                  "(6k+2) x 6k x 2k cells, clamped at y = 0. unknowns: primal "
                  "and dual unknowns; the 3 x 1 x 1 m brick in 6k x 2k x 2k "
                  "cells, clamped at x = 0. Both readings give every row of "
                  "the table exactly.",
                  prm,
                  Patterns::Selection("nodes|unknowns"));
  }



  double
  GeometryParameters::n_cells() const
  {
    double cells = std::pow(8., global_refinement);
    for (const unsigned int n : subdivisions)
      cells *= n;
    return cells;
  }



  std::string
  GeometryParameters::entry_of_size() const
  {
    return table_1_level > 0 ? "Geometry/Table 1 level"
           : global_refinement == 0 ||
               n_cells() / std::pow(8., global_refinement) > max_cells
             ? "Geometry/Subdivisions"
             : "Geometry/Global refinement";
  }



  MaterialParameters::MaterialParameters()
    : ParameterAcceptor("Material")
  {
    add_parameter("Young's modulus",
                  youngs_modulus,
                  "E of the isotropic linear elastic body, > 0. Unit: Pa. The "
                  "default is the steel of the reference brick.",
                  prm,
                  Patterns::Double());
    add_parameter("Poisson ratio",
                  poisson_ratio,
                  "nu, above -1 and below 0.5. Trilinear elements lock as it "
                  "approaches 0.5.",
                  prm,
                  Patterns::Double());
  }



  BoundaryParameters::BoundaryParameters()
    : ParameterAcceptor("Boundary conditions")
  {
    add_parameter("Prescribed displacement",
                  prescribed_displacement,
                  "Boundary id and displacement, 'id : ux; uy; uz', several "
                  "separated by '|'. Each component is a formula in x, y, z. "
                  "Unit: m. Zeros clamp the face.",
                  prm,
                  Patterns::Anything());
    add_parameter("Traction",
                  traction,
                  "Boundary id and traction on the body, 'id : tx; ty; tz', "
                  "several separated by '|'. Each component is a formula in x, "
                  "y, z. Unit: Pa.",
                  prm,
                  Patterns::Anything());
    add_parameter("Contact boundary",
                  contact_boundary,
                  "Id of the boundary that may touch the rigid foundation, "
                  "which lies opposite to it along its outward normal.",
                  prm,
                  Patterns::Integer(0));
    add_parameter("Initial gap",
                  initial_gap,
                  "Distance from the undeformed contact boundary to the "
                  "foundation along the outward normal, a formula in x, y, z. "
                  "Negative: initial interference. Unit: m.",
                  prm,
                  Patterns::Anything());
  }



  FrictionParameters::FrictionParameters()
    : ParameterAcceptor("Friction")
  {
    add_parameter("Law",
                  law_name,
                  "frictionless; given: the tangential traction is at most the "
                  "slip stress, at every node of the contact boundary (Tresca "
                  "friction); coulomb: at most the coefficient times the "
                  "contact pressure.",
                  prm,
                  Patterns::Selection("frictionless|given|coulomb"));
    add_parameter("Coefficient",
                  coefficient,
                  "Coefficient F >= 0 of Coulomb's law, a formula in x, y, z.",
                  prm,
                  Patterns::Anything());
    add_parameter("Slip stress",
                  slip_stress,
                  "Slip stress >= 0 of given friction, a formula in x, y, z. "
                  "Unit: Pa.",
                  prm,
                  Patterns::Anything());
  }



  FrictionLaw
  FrictionParameters::law() const
  {
    if (law_name == "given")
      return FrictionLaw::given;
    if (law_name == "coulomb")
      return FrictionLaw::coulomb;
    return FrictionLaw::frictionless;
  }



  ContactSolverParameters::ContactSolverParameters()
    : ParameterAcceptor("Contact solver")
  {
    add_parameter(
      "Method",
      method,
      "gauss seidel: the paper's ALGORITHM GS, alternating between "
      "the normal forces (half-lines) and the tangential forces "
      "(discs, ALGORITHM QPQ). squares: the paper's predecessors "
      "ALG_2 and ALG_4, discs replaced by 'Squares' rotated "
      "squares; another problem, so never certified unless nothing "
      "slips. mpgp: conjugate gradients with projections on "
      "half-lines times discs at once. newton: semismooth Newton "
      "on the dual problem, the fastest. admm: alternating "
      "directions with dense factorisations of Q.",
      prm,
      Patterns::Selection("gauss seidel|squares|mpgp|newton|admm|newton "
                          "multigrid"));
    add_parameter("Tolerance",
                  tolerance,
                  "What every error figure of the certificate has to reach; "
                  "they are relative, so that no unit enters. All inner "
                  "tolerances follow from it.",
                  prm,
                  Patterns::Double(1e-12, 1e-2));
    add_parameter("Maximum iterations",
                  maximum_iterations,
                  "Cap on the iterations of the whole run: Gauss-Seidel "
                  "sweeps, Newton steps, iterations of admm, stretches of 20 "
                  "products with Q of mpgp and squares. The run that meets it "
                  "writes its files and ends with status 2.",
                  prm,
                  Patterns::Integer(1));
    add_parameter(
      "Disc solver",
      disc_solver,
      "How gauss seidel realises ALGORITHM QPQ. as printed: stops "
      "at every circle it meets, releases nodes only when nothing "
      "else is left to do. The others repair this one measure at a "
      "time, each including those before: with expansion, with "
      "proportioning, with projected release (from here on with a "
      "proof of convergence), robust, spectral. newton: the "
      "quadratic program on discs by the semismooth Newton method "
      "instead.",
      prm,
      Patterns::Selection("as printed|with expansion|with proportioning|with "
                          "projected release|robust|spectral|newton"));
    add_parameter("Squares",
                  squares,
                  "Number r of rotated squares in place of the disc in the "
                  "method squares; their intersection is a regular polygon of "
                  "4r sides around the disc.",
                  prm,
                  Patterns::Integer(1, 64));
    add_parameter("Coulomb iteration",
                  coulomb_iteration,
                  "direct: gauss seidel updates the slip bound in every sweep, "
                  "newton and admm solve Coulomb's law itself. fixed point: "
                  "successive approximations by problems of given friction, "
                  "whose contraction is reported; squares and mpgp always do "
                  "that.",
                  prm,
                  Patterns::Selection("direct|fixed point"));
    add_parameter("Accelerate fixed point",
                  accelerate_fixed_point,
                  "Whether successive approximations extrapolate the slip "
                  "bound (Anderson). A step that does not lower the residual "
                  "is undone.");
  }



  bool
  ContactSolverParameters::is_primal() const
  {
    return method == "newton multigrid";
  }



  StiffnessSolverParameters::StiffnessSolverParameters()
    : ParameterAcceptor("Stiffness solver")
  {
    add_parameter("Type",
                  type,
                  "How systems with the stiffness matrix are solved. mumps: "
                  "one sparse factorisation, then cheap solves; multigrid: "
                  "conjugate gradients with geometric multigrid on the levels "
                  "of 'Geometry/Global refinement', without a matrix, for "
                  "large bodies; amg: with algebraic multigrid on the matrix, "
                  "for large bodies without levels. automatic: multigrid, or "
                  "amg without levels, for 'Contact solver/Method = newton "
                  "multigrid', otherwise mumps.",
                  prm,
                  Patterns::Selection("automatic|mumps|amg|multigrid"));
  }



  DualOperatorParameters::DualOperatorParameters()
    : ParameterAcceptor("Dual operator")
  {
    add_parameter("Form",
                  form,
                  "How the dual Hessian Q is held. assembled: as a dense "
                  "matrix of three rows a contact node; by solves: one elastic "
                  "solve a product, no storage.",
                  prm,
                  Patterns::Selection("assembled|by solves"));
  }



  OutputParameters::OutputParameters()
    : ParameterAcceptor("Output")
  {
    add_parameter("Directory",
                  directory,
                  "Where all results are written; made if it does not exist. "
                  "--output on the command line overrides it.");
    add_parameter("Export directory",
                  export_directory,
                  "Where the discrete problem (Q, h, slip bound, areas, nodes) "
                  "and its solution are written for other programs, as an "
                  "FCLIB file and as Matrix Market files; empty: not written. "
                  "--export on the command line overrides it.");
    add_parameter("Write solution",
                  write_solution,
                  "Whether solution.pvtu, the displacement and the stress in "
                  "the whole body, is written: 0.7 kB an unknown on disk. "
                  "contact.pvtu is always written.",
                  prm,
                  Patterns::Bool());
    add_parameter("Print progress",
                  print_progress,
                  "Whether a line is printed for each step of the solver.");
  }



  PerformanceParameters::PerformanceParameters()
    : ParameterAcceptor("Performance")
  {
    add_parameter("Measure one elastic solve",
                  measure_one_elastic_solve,
                  "Also solve the body without contact by conjugate gradients "
                  "with algebraic multigrid, twice, and state the price of "
                  "the contact solve in such solves.");
    add_parameter("Measure factorizations",
                  measure_factorizations,
                  "Also factorise the stiffness matrix (sparse) and the "
                  "assembled dual operator (dense) once more by themselves and "
                  "state the times: units for the cost of the contact solve.");
    add_parameter("Print timing",
                  print_timing,
                  "Whether times and iteration counts are printed at the end. "
                  "summary.json has them in any case.");
  }



  // -------------------------------------------------------------- Parameters

  Parameters::Reset::Reset()
  {
    dealii::ParameterAcceptor::clear();
  }



  void
  Parameters::read(const std::string &file,
                   const std::vector<std::string> &settings,
                   const std::optional<std::string> &output,
                   const std::optional<std::string> &export_directory,
                   const bool has_body)
  {
    dealii::ParameterHandler &prm = dealii::ParameterAcceptor::prm;
    source.read(file, settings, prm);
    if (output)
      source.assign("--output", "Output", "Directory", *output, prm);
    if (export_directory)
      source.assign(
        "--export", "Output", "Export directory", *export_directory, prm);
    if (has_body)
      {
        apply_table_1_level();
        check_body();
      }
    require(!dealii::Utilities::trim(this->output.directory).empty(),
            "Output/Directory",
            "must name a directory");
    require(this->output.export_directory.empty() ||
              !dealii::Utilities::trim(this->output.export_directory).empty(),
            "Output/Export directory",
            "must name a directory or be empty");

    std::ostringstream out;
    prm.print_parameters(out,
                         dealii::ParameterHandler::ShortPRM |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    used_file_ = out.str();
  }



  std::string
  Parameters::stiffness_solver_type() const
  {
    if (stiffness_solver.type != "automatic")
      return stiffness_solver.type;
    if (contact_solver.method != "newton multigrid")
      return "mumps";
    return geometry.global_refinement > 0 ? "multigrid" : "amg";
  }



  bool
  Parameters::is_matrix_free() const
  {
    return stiffness_solver_type() == "multigrid";
  }



  std::string
  Parameters::default_file()
  {
    const Parameters defaults;
    std::ostringstream out;
    dealii::ParameterAcceptor::prm.print_parameters(
      out,
      dealii::ParameterHandler::PRM |
        dealii::ParameterHandler::KeepDeclarationOrder);
    return out.str();
  }



  void
  Parameters::apply_table_1_level()
  {
    const unsigned int k = geometry.table_1_level;
    if (k == 0)
      return;
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



  void
  Parameters::require(const bool condition,
                      const std::string &entry,
                      const std::string &allowed) const
  {
    if (!condition)
      throw InputError(source.describe(entry) + ", " + allowed + ".");
  }



  void
  Parameters::check_body() const
  {
    // Numbers near the ends of the range of a double would overflow in their
    // products; no unit system needs them.
    const auto is_sane = [](const double value) {
      return value >= 1e-30 && value <= 1e30;
    };
    const auto extremes =
      std::minmax_element(geometry.lengths.begin(), geometry.lengths.end());
    require(is_sane(*extremes.first) && is_sane(*extremes.second),
            "Geometry/Lengths",
            "each must be a number > 0 m, from 1e-30 to 1e30");
    require(*extremes.second <= 1e4 * *extremes.first,
            "Geometry/Lengths",
            "the longest may be at most 10000 times the shortest");
    require(is_sane(material.youngs_modulus),
            "Material/Young's modulus",
            "must be a number > 0 Pa, from 1e-30 to 1e30");
    require(material.poisson_ratio > -1. && material.poisson_ratio < 0.5,
            "Material/Poisson ratio",
            "must be above -1 and below 0.5");

    std::ostringstream too_many;
    too_many << "makes " << geometry.n_cells() << " cells, allowed are at most "
             << max_cells;
    require(geometry.n_cells() <= max_cells,
            geometry.entry_of_size(),
            too_many.str());

    // n/m of the table come out only with the face clamped that goes with it
    const auto displacement = parse_boundary_functions(
      boundary.prescribed_displacement,
      source.locate("Boundary conditions/Prescribed displacement"));
    const unsigned int clamped = geometry.table_1_reading == "nodes" ? 2 : 0;
    require(geometry.table_1_level == 0 ||
              (displacement.size() == 1 && displacement.count(clamped) == 1 &&
               boundary.contact_boundary == 4),
            "Geometry/Table 1 reading",
            "does not match the boundary conditions, this reading needs "
            "'Prescribed displacement' on boundary " +
              std::to_string(clamped) + " alone and 'Contact boundary = 4'");

    check_method(friction.law() == FrictionLaw::coulomb);
    check_solvers();
  }



  void
  Parameters::check_solvers() const
  {
    require(contact_solver.method != "admm" ||
              dual_operator.form == "assembled",
            "Contact solver/Method",
            "factorises the dual operator, so 'Dual operator/Form' must be "
            "'assembled'");
    require(
      output.export_directory.empty() ||
        (dual_operator.form == "assembled" && !contact_solver.is_primal()),
      "Output/Export directory",
      "writes the matrix Q, so 'Dual operator/Form' must be 'assembled' "
      "and 'Contact solver/Method' another one than 'newton multigrid'");

    require(stiffness_solver.type != "multigrid" ||
              geometry.global_refinement > 0,
            "Stiffness solver/Type",
            "needs a coarser mesh, so 'Geometry/Global refinement' must be at "
            "least 1, or the type 'amg'");
    require(!contact_solver.is_primal() || stiffness_solver.type != "mumps",
            "Stiffness solver/Type",
            "must be 'automatic', 'multigrid' or 'amg' for 'Contact "
            "solver/Method = newton multigrid'");
    require(!contact_solver.is_primal() ||
              contact_solver.coulomb_iteration == "direct",
            "Contact solver/Coulomb iteration",
            "must be 'direct' for 'Contact solver/Method = newton multigrid'");
    require(!performance.measure_factorizations || !is_matrix_free(),
            "Performance/Measure factorizations",
            "factorises the stiffness matrix, so 'Stiffness solver/Type' must "
            "be 'mumps' or 'amg'");
  }



  void
  Parameters::check_method(const bool is_coulomb) const
  {
    if (contact_solver.method == "squares" && is_coulomb)
      throw InputError(source.describe("Contact solver/Method") +
                       ", is the comparison of the paper's experiment with "
                       "given friction, must be another one for Coulomb "
                       "friction.");
  }
} // namespace stiction
