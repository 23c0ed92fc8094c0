// The projection onto each feasible set is the nearest feasible point:
// Px is feasible and (x − Px)·(y − Px) ≤ 0 for every feasible y, which
// characterises the nearest point of a convex set. It leaves feasible points
// alone, and a NaN stays one.

#include <stiction/qp/sets/feasible_set.h>

#include <limits>
#include <memory>
#include <stdexcept>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

// A random point of one node's set, often on its boundary or at the origin.
VectorXd feasible_node(Random &random, const bool half_line, const bool disc, double g)
{
  const auto pick = [&random](const double outer) {
    const int kind = random.integer(4);
    return kind == 0 ? 0. : kind == 1 ? outer : random.uniform(0., outer);
  };

  VectorXd node(half_line + 2 * disc);
  if (half_line)
    node(0) = pick(3.);
  if (disc)
    {
      const double angle = random.uniform(0., 6.283185307179586);
      const double r     = pick(g);
      node.tail(2) << r * std::cos(angle), r * std::sin(angle);
    }
  return node;
}

void check(const std::string &name, const FeasibleSet &set, const bool half_line,
           const bool disc, const VectorXd &radii)
{
  Random random(1);
  const Index m = set.n_nodes();

  Largest inequality, repeated, outside;
  unsigned int moved_though_feasible = 0, moved_to_the_boundary = 0;
  for (unsigned int sample = 0; sample < 3000; ++sample)
    {
      const VectorXd x = random.log_uniform(1e-3, 1e3) * random.vector(set.size());
      VectorXd Px      = x;
      set.project(Px);

      VectorXd PPx = Px;
      set.project(PPx);
      repeated.add((PPx - Px).lpNorm<Eigen::Infinity>());

      for (Index i = 0; i < m; ++i)
        {
          const auto node = [&](const VectorXd &v) {
            VectorXd entries(set.n_components());
            for (unsigned int c = 0; c < set.n_components(); ++c)
              entries(c) = v(i + c * m);
            return entries;
          };

          if (half_line)
            outside.add(-node(Px)(0));
          if (disc)
            outside.add(node(Px).tail(2).norm() - radii(i));

          // a feasible y that differs from Px at this node only
          const VectorXd y    = feasible_node(random, half_line, disc, radii(i));
          const VectorXd to_x = node(x) - node(Px), to_y = y - node(Px);
          if (to_x.norm() > 0.)
            {
              ++moved_to_the_boundary;
              inequality.add(to_x.dot(to_y) / to_x.norm());
            }

          VectorXd feasible = VectorXd::Zero(set.size());
          for (unsigned int c = 0; c < set.n_components(); ++c)
            feasible(i + c * m) = 0.999 * y(c);
          VectorXd projected = feasible;
          set.project(projected);
          moved_though_feasible += (projected != feasible);
        }
    }

  unsigned int nan_lost = 0, nan_spread = 0;
  for (Index k = 0; k < set.size(); ++k)
    {
      VectorXd x = random.vector(set.size(), -3., 3.), clean = x;
      set.project(clean);
      x(k) = std::numeric_limits<double>::quiet_NaN();
      set.project(x);
      nan_lost += !std::isnan(x(k));
      for (Index j = 0; j < set.size(); ++j)
        nan_spread += (j % m != k % m && x(j) != clean(j));
    }

  std::cout << name << std::endl;
  print("  some points were infeasible", moved_to_the_boundary > 1000);
  print_below("  largest infeasibility of Px", outside, 1e-15);
  print_below("  largest (x - Px).(y - Px)/|x - Px|", inequality, 1e-14);
  print_below("  largest |PPx - Px|", repeated, 1e-15);
  print_count("  feasible points that were moved", moved_though_feasible);
  print_count("  NaN entries that were lost", nan_lost);
  print_count("  other nodes that a NaN changed", nan_spread);
}

bool is_refused(const double radius)
{
  VectorXd radii(2);
  radii << 1., radius;
  unsigned int refusals = 0;
  try
    {
      const Discs discs(radii);
    }
  catch (const std::invalid_argument &)
    {
      ++refusals;
    }
  try
    {
      const HalfLinesTimesDiscs product(radii);
    }
  catch (const std::invalid_argument &)
    {
      ++refusals;
    }
  return refusals == 2;
}

int main()
{
  VectorXd radii(5);
  radii << 1., 0., 0.25, 1e-3, 2.;

  check("HalfLines", HalfLines(radii), true, false, radii);
  check("Discs", Discs(radii), false, true, radii);
  check("HalfLinesTimesDiscs", HalfLinesTimesDiscs(radii), true, true, radii);

  std::cout << "Radii" << std::endl;
  print("  0 is a radius", !is_refused(0.));
  print("  a negative radius is refused", is_refused(-1e-300));
  print("  NaN is refused", is_refused(std::numeric_limits<double>::quiet_NaN()));
}
