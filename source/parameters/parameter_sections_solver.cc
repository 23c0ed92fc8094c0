#include <stiction/base/units.h>
#include <stiction/parameters/parameters.h>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  ContactSolverParameters::ContactSolverParameters()
    : ParameterAcceptor("Contact solver")
  {
    add_parameter("Method", method,
                  "newton: semismooth Newton on the dual problem, the fastest of the "
                  "dual methods; where it stands still, as with bodies that are held "
                  "weakly, its systems are solved directly, and an interior point "
                  "method and successive approximations help. newton multigrid: "
                  "semismooth Newton on the displacements, without Q, for about the "
                  "price of two elastic solves; the one for large bodies. gauss "
                  "seidel: the paper's ALGORITHM GS, alternating between the normal "
                  "forces (half-lines) and the tangential forces (discs, ALGORITHM "
                  "QPQ). mpgp: conjugate gradients with projections on half-lines "
                  "times discs at once. admm: alternating directions with dense "
                  "factorisations of Q. squares: the paper's predecessors ALG_2 and "
                  "ALG_4, discs replaced by 'Squares' rotated squares; another "
                  "problem, so never certified unless nothing slips.",
                  prm,
                  Patterns::Selection("newton|newton multigrid|gauss seidel|mpgp|admm|"
                                      "squares"));
    add_parameter("Tolerance", tolerance,
                  "What every error figure of the certificate has to reach; "
                  "they are relative, so that no unit enters. All inner "
                  "tolerances follow from it.",
                  prm, Patterns::Double(1e-12, 1e-2));
    add_parameter("Maximum iterations", maximum_iterations,
                  "Cap on the iterations of the whole run: Gauss-Seidel "
                  "sweeps, steps of newton (and of its interior point "
                  "method), iterations of admm, stretches of 20 products "
                  "with Q of mpgp and squares. The run that meets it "
                  "writes its files and ends with status 2.",
                  prm, Patterns::Integer(1));
    add_parameter("Disc solver", disc_solver,
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
    add_parameter("Squares", squares,
                  "Number r of rotated squares in place of the disc in the "
                  "method squares; their intersection is a regular polygon of "
                  "4r sides around the disc.",
                  prm, Patterns::Integer(1, 64));
    add_parameter("Coulomb iteration", coulomb_iteration,
                  "direct: gauss seidel updates the slip bound in every sweep, "
                  "newton and admm solve Coulomb's law itself. fixed point: "
                  "successive approximations by problems of given friction, "
                  "whose contraction is reported; squares and mpgp always do "
                  "that.",
                  prm, Patterns::Selection("direct|fixed point"));
  }

  bool ContactSolverParameters::is_primal() const
  {
    return method == "newton multigrid";
  }

  StiffnessSolverParameters::StiffnessSolverParameters()
    : ParameterAcceptor("Stiffness solver")
  {
    add_parameter("Type", type,
                  "How systems with the stiffness matrix are solved. mumps: "
                  "one sparse factorisation, then cheap solves; multigrid: "
                  "conjugate gradients with geometric multigrid on the levels "
                  "of 'Geometry/Global refinement', without a matrix, for "
                  "large bodies; amg: with algebraic multigrid on the matrix, "
                  "for large bodies without levels: with local or adaptive "
                  "refinement, elements of degree 2, orthotropic materials, "
                  "'Volume strain = cell mean'. automatic: multigrid, or amg where "
                  "there is none, for 'Contact solver/Method = newton "
                  "multigrid', otherwise mumps.",
                  prm, Patterns::Selection("automatic|mumps|amg|multigrid"));
  }

  DualOperatorParameters::DualOperatorParameters()
    : ParameterAcceptor("Dual operator")
  {
    add_parameter("Form", form,
                  "How the dual Hessian Q is held. assembled: as a dense "
                  "matrix of three rows a contact node; by solves: one elastic "
                  "solve a product, no storage.",
                  prm, Patterns::Selection("assembled|by solves"));
    add_parameter("Symmetric part", symmetric_part,
                  "Of a problem from a file (--problem) alone, whose Q is "
                  "refused where it is not symmetric to 1e-8 of its diagonal. "
                  "true: its symmetric part, (Q + Q^T)/2, is taken in its "
                  "place, which is another problem; how far Q is from it is "
                  "said with the certificate.",
                  prm, Patterns::Bool());
  }

  OutputParameters::OutputParameters()
    : ParameterAcceptor("Output")
  {
    add_parameter("Directory", directory,
                  "Where all results are written; made if it does not exist. "
                  "--output on the command line overrides it.");
    add_parameter("Export directory", export_directory,
                  "Where the discrete problem (Q, h, slip bound, areas, nodes) "
                  "and its solution are written for other programs, as an "
                  "FCLIB file and as Matrix Market files; empty: not written. "
                  "--export on the command line overrides it.");
    add_parameter("Units", units,
                  "The units in which this file is written, of length, force "
                  "and stress; with them labels of results are complete. "
                  "Labels alone: nothing is converted, and any consistent "
                  "system may be used.",
                  prm, Patterns::Selection(Units::choices()));
    add_parameter("Write solution", write_solution,
                  "Whether solution.pvtu, the displacement and the stress in "
                  "the whole body, is written. contact.pvtu is always "
                  "written.",
                  prm, Patterns::Bool());
    add_parameter("Fields", fields,
                  "What solution.pvtu has. basic: displacement, stress, von "
                  "Mises stress, 0.1 kB an unknown on disk; all: strain, "
                  "principal stresses, the stress averaged at nodes over the "
                  "cells of the same material, reactions of the supports, "
                  "material and body as well, for twice the size and time.",
                  prm, Patterns::Selection("basic|all"));
    add_parameter("Double precision", double_precision,
                  "Whether displacement.csv, the displacement and the reaction "
                  "of every node of the body, and contact.csv, what "
                  "happens at every contact node, are written besides, as text "
                  "with 17 digits. The .vtu files have the 7 digits of "
                  "single precision.",
                  prm, Patterns::Bool());
    add_parameter("Print progress", print_progress,
                  "Whether a line is printed for each step of the solver.");
  }

  PerformanceParameters::PerformanceParameters()
    : ParameterAcceptor("Performance")
  {
    add_parameter("Measure one elastic solve", measure_one_elastic_solve,
                  "Also solve the body without contact by conjugate gradients "
                  "with the multigrid of the run (algebraic where there is "
                  "none), twice, and state the price of "
                  "the contact solve in such solves.");
    add_parameter("Measure factorizations", measure_factorizations,
                  "Also factorise the stiffness matrix (sparse) and the "
                  "assembled dual operator (dense) once more by themselves and "
                  "state the times: units for the cost of the contact solve.");
    add_parameter("Print timing", print_timing,
                  "Whether times and iteration counts are printed at the end. "
                  "summary.json has them in any case.");
  }
} // namespace stiction
