// On discs, and on half-lines times discs, Proportioning returns the solution
// of the quadratic program: that of 1e5 projected gradient steps. A node that
// is balanced on its circle up to rounding does not keep others from moving.

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  void check(const std::string &name, const bool with_half_lines)
  {
    Random random(7);
    unsigned int inside = 0, on_circle = 0, open = 0, carrying = 0;
    unsigned int not_solved[2] = {0, 0}, infeasible = 0;
    Largest distance[2], energy_above[2];
    for (unsigned int k = 0; k < 40; ++k)
      {
        const Index m         = 1 + k % 4;
        const Index n         = with_half_lines ? 3 * m : 2 * m;
        const Index normal    = n - 2 * m; // number of half-lines
        const MatrixXd matrix = random.spd(n, 5.);
        const VectorXd b      = random.vector(n, -1., 2.);
        VectorXd radii        = random.vector(m, 0.1, 4.);
        if (k % 5 == 0)
          radii(0) = 0.;
        const VectorXd reference = reference_solution(matrix, b, normal, radii);
        for (Index i = 0; i < m; ++i)
          if (std::hypot(reference(normal + i), reference(normal + m + i)) <
              0.999 * radii(i))
            ++inside;
          else
            ++on_circle;
        for (Index i = 0; i < normal; ++i)
          ++(reference(i) > 0. ? carrying : open);

        const DenseOperator A(matrix);
        const Discs discs(radii);
        const HalfLinesTimesDiscs product(radii);
        const FeasibleSet &set =
          with_half_lines ? static_cast<const FeasibleSet &>(product) : discs;
        const double tolerances[2] = {1e-4, 1e-10};
        for (int t = 0; t < 2; ++t)
          for (const double start : {0., 1.})
            {
              VectorXd x        = VectorXd::Zero(n);
              x.tail(m)         = start * radii;
              VectorXd gradient = matrix * x - b;
              const SolverRun statistics =
                Proportioning(A, set, 1.)
                  .solve(x, gradient, {VectorXd::Ones(m), 1.}, tolerances[t], 5000);
              not_solved[t] += !statistics.converged;
              distance[t].add((x - reference).norm());
              energy_above[t].add(energy(matrix, b, x) - energy(matrix, b, reference));
              VectorXd projected = x;
              project(projected, normal, radii);
              infeasible += !((x - projected).norm() <= 1e-15 * radii.sum());
            }
      }

    std::cout << name << std::endl;
    print("  nodes inside their disc and nodes on their circle",
          inside >= 10 && on_circle >= 10);
    if (with_half_lines)
      print("  nodes that carry and nodes that do not", carrying >= 10 && open >= 10);
    print_count("  infeasible solutions", infeasible);
    print_count("  runs not converged to 1e-4", not_solved[0]);
    print_below("    distance from the reference", distance[0], 1e-3);
    print_below("    energy above the reference", energy_above[0], 1e-4);
    print_count("  runs not converged to 1e-10", not_solved[1]);
    print_below("    distance from the reference", distance[1], 1e-8);
    print_below("    energy above the reference", energy_above[1], 1e-10);
  }

  // Two nodes that do not know of each other, A = I: the first balanced on
  // its circle (up to rounding), the second on its circle with its load
  // turned by a right angle.
  void check_balanced_node()
  {
    Random random(8);
    unsigned int held_up = 0;
    for (unsigned int k = 0; k < 100; ++k)
      {
        const double angle = random.uniform(0., 6.283185307179586);
        VectorXd x(4), b(4), exact(4);
        x << std::cos(angle), 1., std::sin(angle), 0.;
        b << 2. * std::cos(angle), 0., 2. * std::sin(angle), 2.;
        exact << x(0), 0., x(2), 1.;

        const MatrixXd matrix = MatrixXd::Identity(4, 4);
        const DenseOperator A(matrix);
        const Discs discs(VectorXd::Ones(2));
        VectorXd gradient = x - b;
        Proportioning(A, discs, 1.)
          .solve(x, gradient, {VectorXd::Ones(2), 1.}, 1e-6, 1000);
        held_up += !((x - exact).norm() < 1e-5);
      }
    std::cout << "A balanced node beside one that has to move" << std::endl;
    print_count("  runs in which it holds up the other", held_up);
  }
} // namespace

int main()
{
  check("Discs", false);
  check("Half-lines times discs", true);
  check_balanced_node();
}
