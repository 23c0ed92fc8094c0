// The paper's Lemma 3.1: x solves the quadratic program on discs if and only
// if r = 0 at nodes inside their disc and g r = −‖r‖ x on the circles. Every
// variant of ALGORITHM QPQ returns such a point, and brute force finds none
// of lower energy: a grid in polar coordinates at one node, 1e5 projected
// gradient steps at two and three.

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/disc_active_set.h>

#include <vector>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  const DiscActiveSet::Variant variants[] = {
    DiscActiveSet::Variant::as_printed,
    DiscActiveSet::Variant::with_expansion,
    DiscActiveSet::Variant::with_proportioning,
    DiscActiveSet::Variant::with_projected_release,
    DiscActiveSet::Variant::robust,
    DiscActiveSet::Variant::spectral};
  const char *const names[] = {
    "as_printed", "with_expansion", "with_proportioning", "with_projected_release",
    "robust",     "spectral"};

  struct Problem
  {
    // Spectrum within [0.2, 1]: the error is a few residuals. Radii such that
    // nodes inside and on their circles both occur.
    Problem(Random &random, const Index m)
      : A(random.spd(2 * m, 5.))
      , b(random.vector(2 * m))
      , radii(random.vector(m, 0.2, 4.))
    {
    }

    MatrixXd A;
    VectorXd b, radii;
  };

  // How far x is from the conditions of the lemma: 0 if it meets them.
  double lemma_violation(const Problem &problem, const VectorXd &x)
  {
    const Index m    = problem.radii.size();
    const VectorXd r = problem.A * x - problem.b;
    double largest   = 0.;
    for (Index i = 0; i < m; ++i)
      {
        const double g      = problem.radii(i);
        const double norm_x = std::hypot(x(i), x(i + m));
        const double norm_r = std::hypot(r(i), r(i + m));
        largest             = std::max(largest, norm_x < g * (1. - 1e-9)
                                                  ? norm_r
                                                  : std::hypot(r(i) + norm_r / g * x(i),
                                                               r(i + m) + norm_r / g * x(i + m)));
      }
    return largest;
  }

  // One node: the best of a grid over the disc, then of finer and finer grids
  // around the best, to a cell of 1e-9.
  VectorXd best_of_grid(const Problem &problem)
  {
    const double pi = 3.141592653589793, g = problem.radii(0);
    double radius = g / 2., angle = 0.; // centre of the grid
    double half_radius = g / 2., half_angle = pi;
    VectorXd x(2), best                     = VectorXd::Zero(2);
    double least = 0.; // the energy of the centre
    while (half_angle > 1e-9)
      {
        double next_radius = radius, next_angle = angle;
        for (int i = -20; i <= 20; ++i)
          for (int j = -20; j <= 20; ++j)
            {
              const double rho =
                std::min(std::max(radius + i * half_radius / 20., 0.), g);
              const double phi = angle + j * half_angle / 20.;
              x << rho * std::cos(phi), rho * std::sin(phi);
              const double value = energy(problem.A, problem.b, x);
              if (value < least)
                {
                  least       = value;
                  best        = x;
                  next_radius = rho;
                  next_angle  = phi;
                }
            }
        radius = next_radius;
        angle  = next_angle;
        half_radius /= 4.;
        half_angle /= 4.;
      }
    return best;
  }

  struct Figures
  {
    unsigned int not_converged = 0, infeasible = 0;
    Largest energy_above, violation, distance;
  };

  Figures compare(const Problem &problem, const VectorXd &reference, const int variant)
  {
    Figures figures;
    const DenseOperator A(problem.A);
    const Discs discs(problem.radii);
    // every start: the centre, and a point on every circle
    for (const double start : {0., 1.})
      {
        const Index m     = problem.radii.size();
        VectorXd x        = VectorXd::Zero(2 * m);
        x.tail(m)         = start * problem.radii;
        VectorXd gradient = problem.A * x - problem.b;
        const SolverRun statistics =
          DiscActiveSet(A, discs, 1., variants[variant])
            .solve(x, gradient, {VectorXd::Ones(m), 1.}, 1e-9, 20000);

        figures.not_converged += !statistics.converged;
        for (Index i = 0; i < m; ++i)
          figures.infeasible +=
            !(std::hypot(x(i), x(i + m)) <= problem.radii(i) * (1. + 1e-15));
        figures.energy_above.add(energy(problem.A, problem.b, x) -
                                 energy(problem.A, problem.b, reference));
        figures.violation.add(lemma_violation(problem, x));
        figures.distance.add((x - reference).norm());
      }
    return figures;
  }
} // namespace

int main()
{
  Random random(5);

  // One node, then two and three; the reference of the first kind is only as
  // near as energies tell points apart.
  for (const int kind : {1, 2})
    {
      std::vector<Problem> problems;
      std::vector<VectorXd> references;
      unsigned int inside = 0, on_circle = 0;
      Largest reference_violation;
      unsigned int still_optimal = 0;
      for (int k = 0; k < 40; ++k)
        {
          const Index m = kind == 1 ? 1 : 2 + k % 2;
          problems.emplace_back(random, m);
          references.push_back(
            kind == 1
              ? best_of_grid(problems[k])
              : reference_solution(problems[k].A, problems[k].b, 0, problems[k].radii));
          const VectorXd &x = references.back();
          for (Index i = 0; i < m; ++i)
            if (std::hypot(x(i), x(i + m)) < 0.999 * problems[k].radii(i))
              ++inside;
            else
              ++on_circle;
          reference_violation.add(lemma_violation(problems[k], x));

          // only the solution meets the conditions
          for (int other = 0; other < 20; ++other)
            {
              VectorXd y = x + 0.1 * random.vector(2 * m);
              project(y, 0, problems[k].radii);
              if ((y - x).norm() > 1e-2)
                still_optimal += (lemma_violation(problems[k], y) < 1e-4);
            }
        }

      std::cout << (kind == 1 ? "One node against a polar grid"
                              : "Two and three nodes against 1e5 steps")
                << std::endl;
      print("  nodes inside their disc and nodes on their circle",
            inside >= 10 && on_circle >= 10);
      print_below("  violation of the lemma by the reference", reference_violation,
                  kind == 1 ? 1e-6 : 1e-12);
      print_count("  other points that meet the conditions of the lemma", still_optimal);
      for (int variant = 0; variant < 6; ++variant)
        {
          Figures all;
          for (unsigned int k = 0; k < problems.size(); ++k)
            {
              const Figures one = compare(problems[k], references[k], variant);
              all.not_converged += one.not_converged;
              all.infeasible += one.infeasible;
              all.energy_above.add(one.energy_above.value());
              all.violation.add(one.violation.value());
              all.distance.add(one.distance.value());
            }
          std::cout << "  Variant " << names[variant] << std::endl;
          print_count("    problems not solved", all.not_converged);
          print_count("    nodes outside their disc", all.infeasible);
          print_below("    violation of the lemma", all.violation, 1e-8);
          print_below("    energy above brute force", all.energy_above, 1e-10);
          print_below("    distance from brute force", all.distance,
                      kind == 1 ? 1e-6 : 1e-8);
        }
    }
}
