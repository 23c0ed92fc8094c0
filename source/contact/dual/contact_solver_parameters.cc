#include <stiction/contact/dual/contact_solver_parameters.h>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  ContactSolverParameters::ContactSolverParameters()
    : ParameterAcceptor("Contact solver")
  {
    add_parameter(
      "Method", method,
      "automatic: newton multigrid, or newton where that is not taken, for a problem "
      "from a file, and beside 'Form = by solves', 'Type = mumps', 'Coulomb iteration = "
      "fixed point', 'Export directory' or 'Measure factorizations', or where newton is "
      "known to be better: small bodies that supports hold, a stiff side of a pair with "
      "small cells. newton: semismooth Newton on the dual problem, the fastest of the "
      "dual methods; where it stands still, as with bodies that are held weakly, its "
      "systems are solved directly, and an interior point method and successive "
      "approximations help. newton multigrid: semismooth Newton on the displacements, "
      "without Q, for about the price of two elastic solves; where its steps come no "
      "closer, they take turns with an interior point method, and where that does not "
      "help, newton goes on for bodies up to 200,000 unknowns. gauss seidel: the paper's "
      "ALGORITHM GS, alternating between the normal forces (half-lines) and the "
      "tangential forces (discs, ALGORITHM QPQ). mpgp: conjugate gradients with "
      "projections on half-lines times discs at once. admm: alternating directions with "
      "dense factorisations of Q. squares: the paper's predecessors ALG_2 and ALG_4, "
      "discs replaced by 'Squares' rotated squares; another problem, so never certified "
      "unless nothing slips.",
      prm,
      Patterns::Selection("automatic|newton|newton multigrid|gauss seidel|"
                          "mpgp|admm|squares"));
    add_parameter("Tolerance", tolerance,
                  "What every error figure of the certificate has to reach; "
                  "they are relative, so that no unit enters. All inner "
                  "tolerances follow from it.",
                  prm, Patterns::Double(1e-12, 1e-2));
    add_parameter("Maximum iterations", maximum_iterations,
                  "Cap on the iterations of a solve: Gauss-Seidel sweeps, steps of "
                  "newton (and of its interior point method), iterations of admm, "
                  "stretches of 20 products with Q of mpgp and squares. Load steps and "
                  "meshes, each search for the place of a free body or a pressed "
                  "obstacle, and a method that goes on for another count anew. The run "
                  "that meets it writes its files and ends with status 2.",
                  prm, Patterns::Integer(1));
    add_parameter("Disc solver", disc_solver,
                  "How gauss seidel realises ALGORITHM QPQ. as printed: stops at every "
                  "circle it meets, releases nodes only when nothing else is left to do. "
                  "The others repair this one measure at a time, each including those "
                  "before: with expansion, with proportioning, with projected release "
                  "(from here on with a proof of convergence), robust, spectral. newton: "
                  "the quadratic program on discs by the semismooth Newton method "
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
                  "direct: gauss seidel updates the slip bound in every sweep, newton "
                  "and admm solve Coulomb's law itself. fixed point: successive "
                  "approximations by problems of given friction, whose contraction is "
                  "reported; squares and mpgp always do that.",
                  prm, Patterns::Selection("direct|fixed point"));
  }

  bool ContactSolverParameters::is_primal() const { return method == "newton multigrid"; }
} // namespace stiction
