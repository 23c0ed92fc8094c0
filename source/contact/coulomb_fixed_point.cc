#include <stiction/contact/contact_surface.h>
#include <stiction/contact/coulomb_fixed_point.h>
#include <stiction/contact/schur_complement.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/stiffness_solver.h>
#include <stiction/parameters.h>

#include <deal.II/lac/trilinos_vector.h>

#include <algorithm>
#include <limits>

namespace stiction
{
  namespace
  {
    // The part of its first error to which an approximation is solved. Solved
    // further, it would only be nearer to a bound that is about to change.
    constexpr double approximation_reduction = 0.3;

    // What the dual residual has to reach, as a part of the tolerance: the
    // certificate measures in scales of the next iterate.
    constexpr double safety = 0.5;

    // Approximations without a new smallest residual before giving up.
    constexpr unsigned int max_idle_steps = 30;

    // Other figures decide too: a complementarity of more than the KKT residual
    // (where the pressure is above p0) asks for a smaller one.
    double
    share_of_kkt(const Certificate &certificate)
    {
      const Certificate::Figures &figures = certificate.figures();
      const double largest                = std::max({figures.kkt_residual,
                                                      figures.penetration,
                                                      figures.complementarity,
                                                      figures.cone_violation});
      return largest > 0. ? std::max(figures.kkt_residual / largest, 0.01) : 1.;
    }

    double
    ratio(const double after, const double before)
    {
      return before > 0. ? after / before : 0.;
    }
  } // namespace



  CoulombFixedPoint::CoulombFixedPoint(
    const LinearElasticity &elasticity,
    const ContactSurface &surface,
    const SchurComplement &schur,
    StiffnessSolver &stiffness_solver,
    GivenFrictionSolver &given_friction_solver,
    const ContactSolverParameters &parameters)
    : elasticity_(elasticity)
    , surface_(surface)
    , schur_(schur)
    , stiffness_solver_(stiffness_solver)
    , given_friction_solver_(given_friction_solver)
    , parameters_(parameters)
  {
  }



  ContactSolution
  CoulombFixedPoint::solve(const Observer &observer)
  {
    const bool bound_changes = surface_.law() == FrictionLaw::coulomb;
    const double tolerance   = parameters_.tolerance;
    const auto infinity      = std::numeric_limits<double>::infinity();

    ContactSolution solution;
    solution.lambda = Eigen::VectorXd::Zero(3 * surface_.n_nodes());
    certify(solution);
    DualIterate iterate{solution.lambda, solution.certificate->gradient()};

    double residual = solution.certificate->figures().kkt_residual;
    double smallest = infinity, change = 0.;
    for (unsigned int idle_steps = 0;;)
      {
        const auto report = [&](const ContactStep &step) {
          ContactStep row     = step;
          row.multiplications = schur_.n_multiplications();
          row.normal_force    = iterate.lambda.head(surface_.n_nodes()).sum();
          observer(row);
        };

        double last_residual = residual;
        StoppingRule rule;
        rule.residual =
          std::max(safety * tolerance * share_of_kkt(*solution.certificate),
                   bound_changes ? approximation_reduction * residual : 0.);
        rule.change         = bound_changes ? infinity : tolerance;
        rule.max_iterations = parameters_.maximum_iterations - solution.sweeps;
        const GivenFrictionResult result = given_friction_solver_.solve(
          iterate,
          surface_.slip_bound(iterate.lambda),
          solution.certificate->scaling(),
          rule,
          [&](const unsigned int sweep, const double r, const double c) {
            if (!bound_changes)
              report({solution.sweeps + sweep,
                      solution.sweeps + sweep,
                      0.,
                      r,
                      c,
                      ratio(r, last_residual),
                      0.});
            last_residual = r;
          });
        solution.sweeps += result.iterations;

        const double norm = iterate.lambda.norm();
        change =
          norm > 0. ? (iterate.lambda - solution.lambda).norm() / norm : 0.;
        solution.lambda = iterate.lambda;
        certify(solution);
        iterate.gradient         = solution.certificate->gradient();
        const double before      = residual;
        residual                 = solution.certificate->figures().kkt_residual;
        const double contraction = ratio(residual, before);
        if (bound_changes)
          {
            ++solution.coulomb_iterations;
            report({solution.coulomb_iterations,
                    solution.sweeps,
                    0.,
                    residual,
                    change,
                    contraction,
                    0.});
          }

        // the paper's rule on top: the slip bound has come to rest
        solution.converged = solution.certificate->converged(tolerance);
        if (solution.converged && (!bound_changes || change <= tolerance))
          return solution;

        idle_steps = residual < 0.9 * smallest ? 0 : idle_steps + 1;
        smallest   = std::min(smallest, residual);
        if (solution.sweeps >= parameters_.maximum_iterations)
          solution.reason =
            "the cap of " + std::to_string(parameters_.maximum_iterations) +
            " sweeps was met, raise 'Contact solver/Maximum iterations'";
        else if ((result.iterations == 0 && change == 0.) || result.stagnated ||
                 (idle_steps >= max_idle_steps && residual < 1e-6))
          solution.reason =
            "rounding or the accuracy of the linear solver prevents a smaller "
            "one, raise 'Contact solver/Tolerance'";
        else if (idle_steps >= max_idle_steps)
          solution.reason =
            "the successive approximations of Coulomb friction do not "
            "contract (last factor " +
            std::to_string(contraction) + "), lower 'Friction/Coefficient'";
        if (!solution.reason.empty())
          {
            if (solution.converged) // nothing is left to explain
              solution.reason.clear();
            return solution;
          }
      }
  }



  void
  CoulombFixedPoint::certify(ContactSolution &solution) const
  {
    LA::Vector force = elasticity_.constrained_load();
    surface_.add_transpose_B(-1., solution.lambda, force);
    solution.u = std::make_unique<LA::Vector>(elasticity_.zero_vector());
    stiffness_solver_.solve(*solution.u, force);
    solution.certificate = std::make_unique<Certificate>(
      elasticity_, surface_, *solution.u, solution.lambda);
  }
} // namespace stiction
