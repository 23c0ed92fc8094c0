// largest_feasible_step() is the α at which x + α d leaves the set: feasible
// up to α, on the boundary at α, outside right after it, and infinite if the
// set never ends. This must hold to rounding also where the quadratic formula
// is prone to cancel: on the circle, and for directions nearly tangential.

#include <stiction/qp/sets/feasible_set.h>

#include <limits>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double pi           = 3.141592653589793;
  using Wide                = long double;

  // ‖x + α d‖/g − 1 at the only node, in long double.
  Wide outside(const VectorXd &x, const VectorXd &d, const Wide alpha, const double g)
  {
    const Wide y1 = x(0) + alpha * d(0), y2 = x(1) + alpha * d(1);
    return std::sqrt(y1 * y1 + y2 * y2) / g - 1.L;
  }

  // The step in long double, from the same rounded x and d.
  Wide step_in_long_double(const VectorXd &x, const VectorXd &d, const Wide g)
  {
    const Wide x1 = x(0), x2 = x(1), d1 = d(0), d2 = d(1);
    const Wide a    = d1 * d1 + d2 * d2;
    const Wide b    = x1 * d1 + x2 * d2;
    const Wide c    = std::max(0.L, g * g - x1 * x1 - x2 * x2);
    const Wide root = std::sqrt(b * b + a * c);
    return b > 0.L ? c / (b + root) : (root - b) / a;
  }

  // A node at the distance (1 − depth) g from the centre; d makes the angle
  // `turn` with the tangent, outwards if positive.
  void check_disc(const std::string &name, const bool well_conditioned,
                  const double least_depth, const double largest_depth,
                  const double least_turn, const double largest_turn, const double sign)
  {
    Random random(3);
    Largest before, at_the_end, error;
    unsigned int not_outside_after = 0, negative = 0;
    for (unsigned int sample = 0; sample < 3000; ++sample)
      {
        const double g     = random.log_uniform(1e-6, 1e6);
        const double angle = random.uniform(0., 2. * pi);
        const double depth =
          largest_depth > 0. ? random.log_uniform(least_depth, largest_depth) : 0.;
        const double turn =
          largest_turn > 0. ? sign * random.log_uniform(least_turn, largest_turn) : 0.;
        const double direction =
          angle + (random.integer(2) == 0 ? pi / 2. - turn : turn - pi / 2.);
        const double length = random.log_uniform(1e-9, 1e9);

        VectorXd x(2), d(2);
        x << std::cos(angle), std::sin(angle);
        d << std::cos(direction), std::sin(direction);
        x *= (1. - depth) * g;
        d *= length;

        const double alpha = Discs(VectorXd::Constant(1, g)).largest_feasible_step(x, d);
        negative += !(alpha >= 0.);
        for (const Wide part : {0.L, 0.25L, 0.5L, 0.75L, 0.999999L, 1.L})
          before.add(static_cast<double>(outside(x, d, part * alpha, g)));
        // Where the step is zero or nearly so a part in 1e6 of it is nothing:
        // a part in 1e6 of the radius is added too.
        const Wide more = alpha * 1.000001L + 1e-6L * g / length;
        not_outside_after += !(outside(x, d, more, g) > 1e-14L);
        at_the_end.add(static_cast<double>(std::abs(outside(x, d, alpha, g))));
        if (well_conditioned)
          error.add(
            static_cast<double>(std::abs(alpha / step_in_long_double(x, d, g) - 1.L)));
      }

    std::cout << name << std::endl;
    print_count("  negative steps", negative);
    print_below("  largest |x + t d|/g - 1 for t <= alpha", before, 2e-15);
    print_below("  largest ||x + alpha d|/g - 1|", at_the_end, 2e-15);
    print_count("  steps after which the disc is not left", not_outside_after);
    if (well_conditioned)
      print_below("  largest relative error of alpha", error, 1e-14);
  }
} // namespace

int main()
{
  check_disc("Inside, outwards", true, 0.1, 1., 0.1, 1.5, 1.);
  check_disc("Inside, inwards", true, 0.1, 1., 0.1, 1.5, -1.);
  check_disc("On the circle, inwards", true, 0., 0., 0.1, 1.5, -1.);
  check_disc("On the circle, outwards", false, 0., 0., 1e-3, 1.5, 1.);
  check_disc("Near the circle, outwards", false, 1e-16, 1e-3, 1e-3, 1.5, 1.);
  check_disc("On the circle, nearly tangential, outwards", false, 0., 0., 1e-16, 1e-3,
             1.);
  check_disc("On the circle, nearly tangential, inwards", false, 0., 0., 1e-16, 1e-3,
             -1.);
  check_disc("On the circle, tangential", false, 0., 0., 0., 0., 1.);
  check_disc("Near the circle, nearly tangential", false, 1e-16, 1e-3, 1e-16, 1e-3, -1.);

  // ------------------------------------------------------------ half-lines
  const HalfLines half_lines(VectorXd::Zero(3));
  VectorXd x(3), d(3);
  x << 1., 0., 3.;
  std::cout << "Half-lines" << std::endl;
  d << -0.5, 1., -4.;
  print("  the first node to reach zero decides",
        half_lines.largest_feasible_step(x, d) == 0.75);
  d << 0., 1., -4.;
  print("  a node that does not move does not decide",
        half_lines.largest_feasible_step(x, d) == 0.75);
  d << -0.5, -1e-300, 1.;
  print("  a node at zero cannot go down", half_lines.largest_feasible_step(x, d) == 0.);
  d << 1., 0., 2.;
  print("  upwards there is no end", half_lines.largest_feasible_step(x, d) == infinity);

  // -------------------------------------------------------------- products
  // Nodes: on its circle, a disc that is a point, inside.
  VectorXd radii(3);
  radii << 1., 0., 2.;
  const Discs discs(radii);
  const HalfLinesTimesDiscs product(radii);
  VectorXd t(6), s(6);
  t << 1., 0., 0., 0., 0., 1.;
  std::cout << "Several nodes" << std::endl;
  s.setZero();
  print("  without a direction there is no end",
        discs.largest_feasible_step(t, s) == infinity);
  s << -1., 0., 0., 0., 0., -1.;
  print("  the node that leaves first decides, at 2 of 2 and 3",
        std::abs(discs.largest_feasible_step(t, s) - 2.) < 1e-15);
  s << -1., 0., 0., 0., 0., -3.;
  print("  the node that leaves first decides, at 1 of 2 and 1",
        std::abs(discs.largest_feasible_step(t, s) - 1.) < 1e-15);
  s << -1., 1e-100, 0., 0., 0., -1.;
  print("  a disc that is a point is left at once",
        discs.largest_feasible_step(t, s) == 0.);

  VectorXd xt(9), ds(9);
  s << -1., 0., 0., 0., 0., -1.;
  xt << x, t;
  ds << -0.25, 0., -1., s;
  print("  half-lines times discs: the discs end first, at 2",
        std::abs(product.largest_feasible_step(xt, ds) - 2.) < 1e-15);
  ds << -1., 0., -1., s;
  print("  half-lines times discs: the half-lines end first, at 1",
        std::abs(product.largest_feasible_step(xt, ds) - 1.) < 1e-15);
}
