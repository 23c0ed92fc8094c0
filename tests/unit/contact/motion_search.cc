// Multipliers of the balance of a body: where the forces are linear in them Newton's
// first step is the answer; with kinks, from which its steps would run away, a shorter
// step or one of the method of multipliers is taken, and it is found nevertheless; where
// Newton's step is beyond all measure that of the method of multipliers is taken.

#include <stiction/contact/dual/motion_search.h>

#include "tests.h"

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  Eigen::VectorXd number(const double x) { return Eigen::VectorXd::Constant(1, x); }

  // Looks for the zero of a growing function with this slope.
  void check(const std::string &name, const std::function<double(double)> &f,
             const std::function<double(double)> &slope)
  {
    MotionSearch search;
    double x = 10., plain_newton = x;
    unsigned int n = 0;
    for (; n < 100 && std::abs(f(x)) > 1e-12; ++n)
      {
        x = search.next(number(x), number(x - f(x)), std::abs(f(x)),
                        [&]() { return number(-f(x) / slope(x)); })(0);
        plain_newton -= f(plain_newton) / slope(plain_newton);
      }
    out() << name << ": found " << yes(std::abs(f(x)) <= 1e-12) << ", in one step "
          << yes(n == 1) << ", by Newton's method alone "
          << yes(std::abs(f(plain_newton)) <= 1e-12) << std::endl;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check(
    "linear", [](const double x) { return 0.3 * x - 6.; }, [](double) { return 0.3; });
  check(
    "saturated", [](const double x) { return std::atan(x - 2.); },
    [](const double x) { return 1. / (1. + (x - 2.) * (x - 2.)); });

  MotionSearch search;
  const Eigen::VectorXd next =
    search.next(number(1.), number(1.5), 1., []() { return number(1e7); });
  out() << "a step beyond all measure: as the method of multipliers "
        << yes(next(0) == 1.5) << std::endl;
}
