// The natural residual is the figure it is said to be, is zero if and only if
// x is optimal, does not depend on the units of force and length, and is NaN
// as soon as one number that enters it is.

#include <stiction/qp/sets/feasible_set.h>

#include <limits>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  const double pi = 3.141592653589793;

  // An optimal pair of half-lines times discs, all kinds of nodes.
  struct Pair
  {
    Pair(Random &random, const VectorXd &radii)
      : x(VectorXd::Zero(3 * radii.size()))
      , gradient(VectorXd::Zero(3 * radii.size()))
    {
      const Index m = radii.size();
      for (Index i = 0; i < m; ++i)
        {
          switch (random.integer(3))
            {
              case 0:
                x(i) = random.uniform(0.1, 1.);
                break;
              case 1:
                gradient(i) = random.uniform(0.1, 1.);
                break;
              default: // about to open
                break;
            }
          const double angle = random.uniform(0., 2. * pi);
          const double pull  = random.uniform(0., 1.);
          const int kind     = random.integer(3);
          const double r     = kind == 0 ? random.uniform(0., 0.9) * radii(i) : radii(i);
          x(i + m)           = r * std::cos(angle);
          x(i + 2 * m)       = r * std::sin(angle);
          if (kind == 1 || radii(i) == 0.)
            {
              gradient(i + m)     = -pull * std::cos(angle);
              gradient(i + 2 * m) = -pull * std::sin(angle);
            }
        }
    }

    VectorXd x, gradient;
  };
} // namespace

int main()
{
  Random random(9);

  // --------------------------------------------------------------- by hand
  // π − w = (0.2, 1.5, 2) with force 2 and displacement 0.5; its tangential
  // part is 2.5 long, the disc 0.5: projected (0.2, 0.3, 0.4).
  std::cout << "By hand" << std::endl;
  VectorXd x(3), gradient(3);
  x << 1., 0.6, 0.;
  gradient << 0.15, -0.6, -1.;
  Scaling scaling{VectorXd::Constant(1, 2.), 0.5};
  std::cout
    << "  a sliding node: "
    << HalfLinesTimesDiscs(VectorXd::Ones(1)).natural_residual(x, gradient, scaling)
    << " (0.5)" << std::endl;
  gradient << 0.5, 0., 0.;
  std::cout
    << "  a node that has to open: "
    << HalfLinesTimesDiscs(VectorXd::Ones(1)).natural_residual(x, gradient, scaling)
    << " (0.5)" << std::endl;
  x << 0.7, 0., 0.;
  gradient << 0., 0., 0.1;
  std::cout
    << "  a sticking node that slips: "
    << HalfLinesTimesDiscs(VectorXd::Ones(1)).natural_residual(x, gradient, scaling)
    << " (0.2)" << std::endl;
  // the largest of several nodes counts, wherever it is
  for (const Index k : {0, 1, 2})
    {
      VectorXd gaps = VectorXd::Constant(3, -0.1);
      gaps(k)       = -0.3;
      std::cout << "  a node that penetrates most: "
                << HalfLines(VectorXd::Zero(3))
                     .natural_residual(VectorXd::Zero(3), gaps, {VectorXd::Ones(3), 0.5})
                << " (0.6)" << std::endl;
    }
  std::cout << "  no nodes: "
            << HalfLines(VectorXd(0))
                 .natural_residual(VectorXd(0), VectorXd(0), {VectorXd(0), 1.})
            << " (0)" << std::endl;

  // ------------------------------------------------- zero iff x is optimal
  VectorXd radii(5);
  radii << 1., 0.3, 0., 2., 0.1;
  const HalfLinesTimesDiscs set(radii);
  Largest optimal, residual_per_spoil;
  double least_per_spoil = 1.;
  for (unsigned int sample = 0; sample < 3000; ++sample)
    {
      const Pair pair(random, radii);
      scaling.force        = random.vector(5, 0.5, 2.);
      scaling.displacement = random.uniform(0.5, 2.);
      optimal.add(set.natural_residual(pair.x, pair.gradient, scaling));

      // Any optimal x is optimal for its own gradient only, but where the
      // gradient may be what it likes: spoil it where it is determined.
      VectorXd spoilt   = pair.gradient;
      const Index i     = random.integer(5);
      const bool normal = random.integer(2) == 0 || radii(i) == 0.;
      if (normal)
        spoilt(i) = pair.x(i) > 0. ? 1e-3 : -1e-3;
      else
        { // aside of x, which is never balanced
          const double norm = std::hypot(pair.x(i + 5), pair.x(i + 10));
          spoilt(i + 5) += -1e-3 * pair.x(i + 10) / norm;
          spoilt(i + 10) += 1e-3 * pair.x(i + 5) / norm;
        }
      const double residual = set.natural_residual(pair.x, spoilt, scaling);
      residual_per_spoil.add(residual * 1e3 * scaling.displacement);
      least_per_spoil = std::min(least_per_spoil, residual * 1e3 * scaling.displacement);
    }
  std::cout << "Zero iff optimal" << std::endl;
  print_below("  largest residual of an optimal pair", optimal, 1e-14);
  // a gradient spoilt by 1e-3 shows as 1e-3/displacement, less on a circle
  print("  a spoilt pair shows at least 2 % of the damage", least_per_spoil > 0.02);
  print("  and never more than all of it", residual_per_spoil.value() < 1. + 1e-10);

  // ----------------------------------------------------------------- units
  Largest change;
  unsigned int not_the_same_bits = 0;
  for (unsigned int sample = 0; sample < 1000; ++sample)
    {
      const VectorXd force = random.vector(5, 0.5, 2.);
      VectorXd point       = random.vector(15, 0., 2.);
      const VectorXd slope = random.vector(15);
      set.project(point);
      const double residual = set.natural_residual(point, slope, {force, 0.7});
      // newton and metre to kilonewton and millimetre, and the like
      for (const double f : {1e-3, 1e6})
        for (const double l : {1e3, 1e-9})
          change.add(std::abs(HalfLinesTimesDiscs(f * radii).natural_residual(
                                f * point, l * slope, {f * force, l * 0.7}) -
                              residual) /
                     residual);
      for (const double f : {std::ldexp(1., 20), std::ldexp(1., -30)})
        for (const double l : {std::ldexp(1., 40), std::ldexp(1., -10)})
          not_the_same_bits +=
            (HalfLinesTimesDiscs(f * radii).natural_residual(
               f * point, l * slope, {f * force, l * 0.7}) != residual);
    }
  std::cout << "Units" << std::endl;
  print_below("  largest relative change with the units", change, 1e-13);
  print_count("  changes with units that are powers of two", not_the_same_bits);

  // ------------------------------------------------------------------- NaN
  const double nan  = std::numeric_limits<double>::quiet_NaN();
  unsigned int lost = 0;
  for (Index k = 0; k < 15; ++k)
    {
      const VectorXd force = VectorXd::Ones(5);
      VectorXd point       = VectorXd::Constant(15, 0.01);
      VectorXd slope       = VectorXd::Constant(15, 0.1);
      VectorXd bad         = point;
      bad(k)               = nan;
      lost += !std::isnan(set.natural_residual(bad, slope, {force, 1.}));
      bad    = slope;
      bad(k) = nan;
      lost += !std::isnan(set.natural_residual(point, bad, {force, 1.}));
      bad        = force;
      bad(k % 5) = nan;
      lost += !std::isnan(set.natural_residual(point, slope, {bad, 1.}));
      lost += !std::isnan(set.natural_residual(point, slope, {force, nan}));
    }
  std::cout << "NaN" << std::endl;
  print_count("  lost ones", lost);
}
