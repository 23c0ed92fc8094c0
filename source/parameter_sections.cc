#include <stiction/parameters.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  GeometryParameters::GeometryParameters()
    : ParameterAcceptor("Geometry")
  {
    add_parameter("Type",
                  type,
                  "The shape of the body. brick: (0,Lx) x (0,Ly) x (0,Lz). Its "
                  "faces have the boundary ids and names 0 left: x = 0, "
                  "1 right: x = Lx, 2 front: y = 0, 3 back: y = Ly, 4 bottom: "
                  "z = 0, 5 top: z = Lz.",
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
    add_parameter("Contact refinement",
                  contact_refinement,
                  "How many more times the cells at the contact boundary are "
                  "cut into eight, and cells around them so that neighbours "
                  "differ by one level. The nodes that hang between small and "
                  "large cells follow their neighbours; contact is imposed at "
                  "the others.",
                  prm,
                  Patterns::Integer(0, 6));
    add_parameter("Contact refinement where",
                  contact_refinement_where,
                  "A formula in x, y, z: 'Contact refinement' cuts the cells "
                  "whose face on the contact boundary has its centre where "
                  "this is above 0, 'x < 1' being 1 where it holds and 0 "
                  "where it does not.",
                  prm,
                  Patterns::Anything());
    add_parameter("Element degree",
                  element_degree,
                  "1: trilinear displacements, 8 nodes a cell; 2: "
                  "triquadratic ones, 27 nodes. Either way contact and "
                  "friction are imposed node by node, with one contact force "
                  "a node of the contact boundary, and its pressure is the "
                  "force over the nodal area, the integral of the node's "
                  "shape function (all positive: of a face of degree 2, 1/36 "
                  "for a corner, 1/9 for an edge, 4/9 for the centre).",
                  prm,
                  Patterns::Integer(1, 2));
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
  GeometryParameters::n_uniform_cells() const
  {
    double cells = std::pow(8., global_refinement);
    for (const unsigned int n : subdivisions)
      cells *= n;
    return cells;
  }



  double
  GeometryParameters::n_cells() const
  {
    // each local refinement makes seven more of every cell of a layer, the
    // largest there is
    const double layer =
      n_uniform_cells() / std::pow(2., global_refinement) /
      *std::min_element(subdivisions.begin(), subdivisions.end());
    return n_uniform_cells() +
           7. / 3. * layer * (std::pow(4., contact_refinement) - 1.);
  }



  std::string
  GeometryParameters::entry_of_size() const
  {
    return table_1_level > 0                    ? "Geometry/Table 1 level"
           : n_cells() > 2. * n_uniform_cells() ? "Geometry/Contact refinement"
           : global_refinement == 0 ||
               n_uniform_cells() / std::pow(8., global_refinement) > max_cells
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



  RefinementParameters::RefinementParameters()
    : ParameterAcceptor("Refinement")
  {
    add_parameter("Adaptive steps",
                  adaptive_steps,
                  "How many times the mesh is refined where the solution needs "
                  "it: the problem is solved and certified, the error is "
                  "estimated cell by cell (in the energy norm, from what the "
                  "stress lacks to be in equilibrium inside the cells, across "
                  "their faces and with the loads and contact forces), the "
                  "cells with the largest errors are cut into eight, and the "
                  "problem is solved again. The files are those of the last "
                  "mesh; it is the last one too if its answer is not "
                  "certified. The estimate has no constants: it says where the "
                  "mesh is too coarse, it is no bound.",
                  prm,
                  Patterns::Integer(0, 50));
    add_parameter("Fraction",
                  fraction,
                  "The cells that are cut are the fewest that make up this "
                  "part of the sum of the squares of the estimated errors; "
                  "above 0, at most 1.",
                  prm,
                  Patterns::Double());
    add_parameter("Maximum unknowns",
                  maximum_unknowns,
                  "No mesh is made that would have more unknowns than about "
                  "this; 0: the memory is the limit.",
                  prm,
                  Patterns::Integer(0));
  }



  BoundaryParameters::BoundaryParameters()
    : ParameterAcceptor("Boundary conditions")
  {
    add_parameter("Prescribed displacement",
                  prescribed_displacement,
                  "Boundary and displacement, 'boundary : ux; uy; uz', several "
                  "separated by '|'. A boundary is given by its number or its "
                  "name. Each component is a formula in x, y, z, or 'free': "
                  "'left : 0; free; free' is a roller or a plane of symmetry. "
                  "Unit: m. Zeros clamp the face.",
                  prm,
                  Patterns::Anything());
    add_parameter("Traction",
                  traction,
                  "Boundary and traction on the body, 'boundary : tx; ty; tz', "
                  "several separated by '|'. Each component is a formula in x, "
                  "y, z. Unit: Pa.",
                  prm,
                  Patterns::Anything());
    add_parameter(
      "Contact boundary",
      contact_boundary,
      "Name or number of the boundary that may touch the rigid foundation, "
      "which lies opposite to it along its outward normal.",
      prm,
      Patterns::Anything());
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
      "on the dual problem, the fastest of the dual methods. admm: "
      "alternating directions with dense factorisations of Q. newton "
      "multigrid: semismooth Newton on the displacements, without Q, "
      "for about the price of two elastic solves; the one for large "
      "bodies.",
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
                  "for large bodies without levels, with local refinement or "
                  "elements of degree 2. automatic: multigrid, or amg where "
                  "there is none, for 'Contact solver/Method = newton "
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
                  "with the multigrid of the run (algebraic where there is "
                  "none), twice, and state the price of "
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
} // namespace stiction
