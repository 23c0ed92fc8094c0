// Half-lines times boxes: the projection is the nearest point entry by entry,
// the largest feasible step ends on a bound and not before or behind, and the
// split gradient is what FeasibleSet promises: the gradient inside, on a bound
// (x − P(x − s r))/s, and both zero exactly at a solution.

#include <stiction/qp/sets/feasible_set.h>

#include <limits>
#include <stdexcept>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  bool throws(const double half_width)
  {
    try
      {
        HalfLinesTimesBoxes(VectorXd::Constant(1, half_width), 2);
      }
    catch (const std::invalid_argument &)
      {
        return true;
      }
    return false;
  }
} // namespace

int main()
{
  Random random(55);
  const double inf              = std::numeric_limits<double>::infinity();
  unsigned int wrong_projection = 0, wrong_free = 0, mixed = 0, endless = 0;
  unsigned int not_optimal = 0, spoilt_unseen = 0, on_bound = 0, inside = 0;
  Largest chopped_error, before_bound, behind_bound;
  for (unsigned int sample = 0; sample < 2000; ++sample)
    {
      const Index m               = 1 + sample % 4;
      const unsigned int n_blocks = sample % 5;
      const Index n               = m * (1 + n_blocks);
      VectorXd b                  = random.vector(m, 0.1, 2.);
      if (sample % 7 == 0)
        b(0) = 0.;
      const HalfLinesTimesBoxes set(b, n_blocks);

      // bounds as one would write them
      VectorXd lower = VectorXd::Zero(n), upper = VectorXd::Constant(n, inf);
      for (Index k = m; k < n; ++k)
        {
          lower(k) = -b(k % m);
          upper(k) = b(k % m);
        }

      VectorXd x              = random.vector(n, -3., 3.);
      const VectorXd expected = x.cwiseMax(lower).cwiseMin(upper);
      set.project(x);
      wrong_projection += (x != expected);

      const VectorXd r  = random.vector(n);
      const double step = random.log_uniform(1e-2, 1e2);
      VectorXd free, chopped;
      set.split(x, r, step, free, chopped);
      const VectorXd moved = (x - step * r).cwiseMax(lower).cwiseMin(upper);
      bool has_free = false, has_bound = false;
      for (Index k = 0; k < n; ++k)
        {
          const bool bound  = x(k) == lower(k) || x(k) == upper(k);
          const double goal = bound ? (x(k) - moved(k)) / step : 0.;
          wrong_free += free(k) != (bound ? 0. : r(k));
          chopped_error.add(std::abs(chopped(k) - goal) * std::min(step, 1.));
          ++(bound ? on_bound : inside);
          has_free  = has_free || !bound;
          has_bound = has_bound || bound;
        }
      mixed += has_free && has_bound;

      const VectorXd d   = random.vector(n);
      const double alpha = set.largest_feasible_step(x, d);
      if (alpha == inf)
        {
          endless += !(n == m && d.minCoeff() >= 0.);
          continue;
        }
      const auto outside = [&](const double part) {
        const VectorXd y = x + part * alpha * d;
        return std::max((lower - y).maxCoeff(), (y - upper).maxCoeff());
      };
      before_bound.add(std::max(outside(0.5), outside(1.)));
      behind_bound.add(alpha > 0. ? -outside(1.001) / alpha : 0.);

      // at a solution, and with one entry that wants to move
      VectorXd optimal = VectorXd::Zero(n);
      for (Index k = 0; k < n; ++k)
        if (lower(k) < upper(k))
          optimal(k) = x(k) == lower(k)   ? std::abs(r(k))
                       : x(k) == upper(k) ? -std::abs(r(k))
                                          : 0.;
        else
          optimal(k) = r(k);
      set.split(x, optimal, step, free, chopped);
      not_optimal += (free + chopped).norm() != 0.;
      const Index k = random.integer(static_cast<int>(n));
      if (lower(k) < upper(k))
        {
          optimal(k) = x(k) == lower(k) ? -0.1 : 0.1;
          set.split(x, optimal, step, free, chopped);
          spoilt_unseen += !((free + chopped).norm() > 1e-3);
        }
    }
  print("Entries inside and on a bound, often at once",
        inside > 1000 && on_bound > 1000 && mixed > 500);
  print_count("Projections that are not entry by entry", wrong_projection);
  print_count("Free entries that are not the gradient inside", wrong_free);
  print_below("Error of the chopped part", chopped_error, 1e-14);
  print_count("Steps without an end where there is one", endless);
  print_below("Farthest outside before the end of the step", before_bound, 1e-14);
  print_below("Inside behind the end of the step", behind_bound, 1e-14);
  print_count("Solutions that are not seen", not_optimal);
  print_count("Gradients that move one entry and are not seen", spoilt_unseen);
  print("A negative half-width and no number throw, zero does not",
        throws(-1.) && throws(std::nan("")) && !throws(0.));
}
