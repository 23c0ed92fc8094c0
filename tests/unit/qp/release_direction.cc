// The paper's unbalanced boundary residual v_i = −r_i − (‖r_i‖/g_i) x_i is a
// feasible descent direction unless the KKT boundary condition
// g r = −‖r‖ x holds, and zero if it does. Along it the disc is left at
// exactly g/‖r‖, which a quadratic formula cannot tell once v is small.

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/disc_active_set.h>

#include <limits>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  const double pi = 3.141592653589793;
  using Wide      = long double;

  // One node on its circle whose residual makes the angle `turn` with the
  // direction −x that would balance it.
  struct Node
  {
    Node(Random &random, const double least_turn, const double largest_turn)
      : x(2)
      , r(2)
    {
      g                  = random.log_uniform(1e-3, 1e3);
      turn               = random.log_uniform(least_turn, largest_turn);
      const double angle = random.uniform(0., 2. * pi);
      const double side  = random.integer(2) == 0 ? turn : -turn;
      x << g * std::cos(angle), g * std::sin(angle);
      r << -std::cos(angle + side), -std::sin(angle + side);
      r *= random.log_uniform(1e-6, 1e6);
    }

    Discs disc() const { return Discs(VectorXd::Constant(1, g)); }

    double g, turn;
    VectorXd x, r;
  };

  Wide dot(const VectorXd &a, const VectorXd &b)
  {
    return static_cast<Wide>(a(0)) * b(0) + static_cast<Wide>(a(1)) * b(1);
  }

  // ‖x + t v‖/g − 1 in long double.
  Wide outside(const Node &node, const VectorXd &v, const Wide t)
  {
    const Wide y1 = node.x(0) + t * v(0), y2 = node.x(1) + t * v(1);
    return std::sqrt(y1 * y1 + y2 * y2) / node.g - 1.L;
  }
} // namespace

int main()
{
  Random random(4);

  // --------------------------- unbalanced nodes: feasible, descent, the step
  unsigned int not_descent = 0, not_inwards = 0, not_left = 0;
  Largest descent, feasible, end, step;
  for (unsigned int sample = 0; sample < 5000; ++sample)
    {
      const Node node(random, 1e-2, pi);
      const Discs disc = node.disc();
      const VectorXd v = unbalanced_boundary_residual(disc, node.x, node.r);
      const Wide vv    = dot(v, v);
      not_descent += !(dot(v, node.r) < 0.L);
      not_inwards += !(dot(v, node.x) < 0.L);
      // on the circle v·r = −½‖v‖² exactly
      descent.add(static_cast<double>(std::abs(2.L * dot(v, node.r) / vv + 1.L)));

      const Wide closed_form = node.g / std::sqrt(dot(node.r, node.r));
      const double alpha     = largest_release_step(disc, node.x, node.r);
      step.add(static_cast<double>(std::abs(alpha / closed_form - 1.L)));
      for (const Wide part : {0.L, 1e-6L, 0.1L, 0.5L, 0.9L, 0.999999L, 1.L})
        feasible.add(static_cast<double>(outside(node, v, part * alpha)));
      end.add(static_cast<double>(std::abs(outside(node, v, alpha))));
      not_left += !(outside(node, v, 1.000001L * alpha) > 1e-14L);
    }
  std::cout << "Unbalanced by 0.01 to pi" << std::endl;
  print_count("  directions that do not lead down", not_descent);
  print_count("  directions that do not lead inwards", not_inwards);
  print_below("  largest |2 v.r/|v|^2 + 1|", descent, 1e-10);
  print_below("  largest |x + t v|/g - 1 for t <= g/|r|", feasible, 2e-15);
  print_below("  largest ||x + (g/|r|) v|/g - 1|", end, 2e-15);
  print_count("  steps after which the disc is not left", not_left);
  print_below("  largest relative error of the step", step, 1e-15);

  // ------------------------------------------------- almost balanced nodes
  // v is of the order 1e-9 ‖r‖: x·v and ‖r‖g cancel to the last digit.
  Largest small, exact;
  unsigned int formula_fails = 0;
  for (unsigned int sample = 0; sample < 1000; ++sample)
    {
      const Node node(random, 3e-10, 3e-9);
      const Discs disc       = node.disc();
      const VectorXd v       = unbalanced_boundary_residual(disc, node.x, node.r);
      const Wide r           = std::sqrt(dot(node.r, node.r));
      const Wide closed_form = node.g / r;
      small.add(static_cast<double>(std::sqrt(dot(v, v)) / r));
      exact.add(static_cast<double>(
        std::abs(largest_release_step(disc, node.x, node.r) / closed_form - 1.L)));
      formula_fails +=
        !(std::abs(disc.largest_feasible_step(node.x, v) / closed_form - 1.L) < 0.1L);
    }
  std::cout << "Unbalanced by 1e-9" << std::endl;
  print_below("  largest |v|/|r|", small, 1e-8);
  print_below("  largest relative error of the step", exact, 1e-15);
  print("  the quadratic formula is wrong by over 10 % for most", formula_fails > 500);

  // ------------------------------------------------------- balanced nodes
  // ... and those that have no balance to keep: inside, and radius zero.
  Largest balanced;
  unsigned int not_zero = 0, finite = 0;
  for (unsigned int sample = 0; sample < 5000; ++sample)
    {
      Node node(random, 1e-2, pi);
      const Discs disc        = node.disc();
      const double multiplier = random.log_uniform(1e-6, 1e6);
      VectorXd v = unbalanced_boundary_residual(disc, node.x, -multiplier * node.x);
      balanced.add(v.norm() / (multiplier * node.g));

      // inside, without a residual, and in a disc that is a point
      VectorXd radii(3), x(6), r(6);
      radii << node.g, node.g, 0.;
      x << 0.999 * node.x(0), node.x(0), 0., 0.999 * node.x(1), node.x(1), 0.;
      r << node.r(0), 0., node.r(0), node.r(1), 0., node.r(1);
      const Discs discs(radii);
      v = unbalanced_boundary_residual(discs, x, r);
      not_zero += (v != VectorXd::Zero(6));
      finite +=
        !(largest_release_step(discs, x, r) == std::numeric_limits<double>::infinity());
    }
  std::cout << "Balanced" << std::endl;
  print_below("  largest |v|/|r|", balanced, 1e-15);
  print_count("  v not zero inside, for r = 0 or for g = 0", not_zero);
  print_count("  release steps that end although v is zero", finite);

  // -------------------------------------------------------- several nodes
  unsigned int wrong_minimum = 0, wrong_node = 0;
  for (unsigned int sample = 0; sample < 1000; ++sample)
    {
      const Node nodes[3] = {Node(random, 1e-2, pi), Node(random, 1e-2, pi),
                             Node(random, 1e-2, pi)};
      VectorXd radii(3), x(6), r(6);
      double minimum = std::numeric_limits<double>::infinity();
      for (Index i = 0; i < 3; ++i)
        {
          radii(i) = nodes[i].g;
          for (Index c = 0; c < 2; ++c)
            {
              x(i + 3 * c) = nodes[i].x(c);
              r(i + 3 * c) = nodes[i].r(c);
            }
          minimum = std::min(
            minimum, largest_release_step(nodes[i].disc(), nodes[i].x, nodes[i].r));
        }
      const Discs discs(radii);
      const VectorXd v = unbalanced_boundary_residual(discs, x, r);
      wrong_minimum += (largest_release_step(discs, x, r) != minimum);
      for (Index i = 0; i < 3; ++i)
        {
          const VectorXd alone =
            unbalanced_boundary_residual(nodes[i].disc(), nodes[i].x, nodes[i].r);
          wrong_node += (v(i) != alone(0) || v(i + 3) != alone(1));
        }
    }
  std::cout << "Three nodes" << std::endl;
  print_count("  steps that are not the smallest of the nodes", wrong_minimum);
  print_count("  nodes that differ from the node alone", wrong_node);
}
