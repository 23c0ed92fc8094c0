// The two parts of the gradient: at nodes inside their set the free part is
// the gradient and the chopped part zero; on the boundary the free part is
// zero and the chopped part (x − P(x − s r))/s, min(r, 0) on a half-line.
// Both are zero if and only if x is optimal.

#include <stiction/qp/sets/feasible_set.h>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  const double pi = 3.141592653589793;
  const Index m   = 6;

  // A point of half-lines times discs, and which parts are on the boundary.
  struct Point
  {
    VectorXd x = VectorXd::Zero(3 * m);
    bool normal_active[m], tangential_active[m];
  };

  Point random_point(Random &random, const VectorXd &radii)
  {
    Point point;
    for (Index i = 0; i < m; ++i)
      {
        point.normal_active[i]     = random.integer(2) == 0;
        point.tangential_active[i] = random.integer(2) == 0 || radii(i) == 0.;
        if (!point.normal_active[i])
          point.x(i) = random.log_uniform(1e-9, 1e3);
        // inside by a part in 1e9 is inside
        const double inside =
          random.integer(2) == 0 ? 1. - 1e-9 : random.uniform(0., 0.99);
        const double r     = radii(i) * (point.tangential_active[i] ? 1. : inside);
        const double angle = random.uniform(0., 2. * pi);
        point.x(i + m)     = r * std::cos(angle);
        point.x(i + 2 * m) = r * std::sin(angle);
      }
    return point;
  }
} // namespace

int main()
{
  Random random(2);
  VectorXd radii(m);
  radii << 1., 0., 0.25, 1e-3, 2., 1e3;
  const HalfLinesTimesDiscs product(radii);
  const HalfLines half_lines(VectorXd::Zero(m));
  const Discs discs(radii);

  // ------------------------------------------------------- the definitions
  unsigned int wrong_free = 0, wrong_zero = 0, wrong_normal = 0;
  unsigned int parts_differ = 0;
  Largest wrong_chopped;
  for (unsigned int sample = 0; sample < 3000; ++sample)
    {
      const Point point       = random_point(random, radii);
      const VectorXd gradient = random.log_uniform(1e-3, 1e3) * random.vector(3 * m);
      const double step       = random.log_uniform(1e-2, 1e2);
      VectorXd free, chopped;
      product.split(point.x, gradient, step, free, chopped);

      for (Index i = 0; i < m; ++i)
        {
          if (point.normal_active[i])
            {
              wrong_zero += (free(i) != 0.);
              wrong_normal += (chopped(i) != std::min(gradient(i), 0.));
            }
          else
            {
              wrong_free += (free(i) != gradient(i));
              wrong_zero += (chopped(i) != 0.);
            }

          // x − P(x − s r) by hand and in long double
          const Index a = i + m, b = i + 2 * m;
          const long double y1 =
            point.x(a) - static_cast<long double>(step) * gradient(a);
          const long double y2 =
            point.x(b) - static_cast<long double>(step) * gradient(b);
          const long double norm   = std::sqrt(y1 * y1 + y2 * y2);
          const long double factor = norm > radii(i) ? radii(i) / norm : 1.L;
          if (point.tangential_active[i])
            {
              wrong_zero += (free(a) != 0. || free(b) != 0.);
              // an error of s·chopped of one unit in the last place of x − s r
              const double unit = static_cast<double>(radii(i) + norm) / step;
              wrong_chopped.add(
                std::abs(double((point.x(a) - factor * y1) / step) - chopped(a)) / unit);
              wrong_chopped.add(
                std::abs(double((point.x(b) - factor * y2) / step) - chopped(b)) / unit);
            }
          else
            {
              wrong_free += (free(a) != gradient(a) || free(b) != gradient(b));
              wrong_zero += (chopped(a) != 0. || chopped(b) != 0.);
            }
        }

      // the product's parts are those of its factors
      VectorXd free_n, chopped_n, free_t, chopped_t;
      half_lines.split(point.x.head(m), gradient.head(m), step, free_n, chopped_n);
      discs.split(point.x.tail(2 * m), gradient.tail(2 * m), step, free_t, chopped_t);
      parts_differ += (free.head(m) != free_n || free.tail(2 * m) != free_t ||
                       chopped.head(m) != chopped_n || chopped.tail(2 * m) != chopped_t);
    }
  print_count("Interior nodes whose free part is not the gradient", wrong_free);
  print_count("Parts that should be zero and are not", wrong_zero);
  print_count("Half-lines whose chopped part is not min(r, 0)", wrong_normal);
  print_below("Largest error of (x - P(x - s r))/s", wrong_chopped, 1e-15);
  print_count("Products that differ from their factors", parts_differ);

  // ------------------------------------ a projected node is an active one
  unsigned int missed = 0;
  for (unsigned int sample = 0; sample < 20000; ++sample)
    {
      VectorXd x = VectorXd::Zero(2 * m);
      for (Index i = 0; i < m; ++i)
        {
          const double angle = random.uniform(0., 2. * pi);
          const double r     = random.log_uniform(2., 1e8);
          x(i)               = radii(i) * r * std::cos(angle);
          x(i + m)           = radii(i) * r * std::sin(angle);
        }
      discs.project(x);
      for (Index i = 0; i < m; ++i)
        missed += !discs.is_active(x, i);
    }
  print_count("Projected nodes not seen as on their circle", missed);

  // ------------------------------------------------- zero iff x is optimal
  // An optimal pair by construction; then one entry of it is spoilt.
  Largest optimal;
  double least_spoilt       = 1.;
  unsigned int spoilt_pairs = 0;
  for (unsigned int sample = 0; sample < 3000; ++sample)
    {
      const Point point = random_point(random, radii);
      VectorXd gradient = VectorXd::Zero(3 * m);
      for (Index i = 0; i < m; ++i)
        {
          if (point.normal_active[i])
            gradient(i) = random.integer(3) * random.uniform(0., 1.);
          if (radii(i) == 0.) // anything balances a disc that is a point
            {
              gradient(i + m)     = random.uniform(-1., 1.);
              gradient(i + 2 * m) = random.uniform(-1., 1.);
            }
          else if (point.tangential_active[i])
            {
              const double multiplier =
                random.integer(3) * random.uniform(0., 1.) / radii(i);
              gradient(i + m)     = -multiplier * point.x(i + m);
              gradient(i + 2 * m) = -multiplier * point.x(i + 2 * m);
            }
        }
      const double step = random.log_uniform(1e-2, 1e-1);
      VectorXd free, chopped;
      product.split(point.x, gradient, step, free, chopped);
      for (Index k = 0; k < 3 * m; ++k)
        {
          const double radius = k < m ? 1. : radii(k % m);
          optimal.add(std::abs(free(k)));
          optimal.add(std::abs(chopped(k)) * step /
                      std::max(radius, 1e-3)); // rounding of x over s
        }

      const Index i      = random.integer(m);
      VectorXd spoilt    = gradient;
      const bool tangent = random.integer(2) == 0;
      if (!tangent)
        {
          // an open node that would close, a closed one with a gap
          spoilt(i) = point.normal_active[i] ? -1e-3 : spoilt(i) + 1e-3;
        }
      else if (radii(i) > 0.)
        {
          const double x1 = point.x(i + m) / radii(i);
          const double x2 = point.x(i + 2 * m) / radii(i);
          if (!point.tangential_active[i])
            spoilt(i + m) += 1e-3; // slips though it sticks
          else if (random.integer(2) == 0)
            {
              spoilt(i + m) += -1e-3 * x2; // slips aside of its traction
              spoilt(i + 2 * m) += 1e-3 * x1;
            }
          else
            {
              spoilt(i + m)     = 1e-3 * x1; // slips against its traction
              spoilt(i + 2 * m) = 1e-3 * x2;
            }
        }
      else
        continue;
      ++spoilt_pairs;
      // A step short beside radius/|r|, lest the circle's curvature matter.
      product.split(point.x, spoilt, 1e-4, free, chopped);
      least_spoilt = std::min(least_spoilt, (free + chopped).norm() * 1e3);
    }
  print_below("Largest part at an optimal x", optimal, 1e-14);
  print("Thousands of pairs were spoilt", spoilt_pairs > 2000);
  print("The parts show at least half of every spoilt 1e-3", least_spoilt > 0.5);
}
