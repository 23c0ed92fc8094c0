// Of affine components s = c + r s the secant of two values meets the fixed point,
// whether they overshoot or creep, unless that takes more than three steps at once; a
// component whose steps grow is left to its own step.

#include <stiction/qp/solvers/componentwise_secant.h>

#include <iostream>

int main()
{
  const Eigen::Array4d r(-0.9, 0.5, 0.9, 1.5), fixed_point(1., -2., 3., 4.);
  const auto S = [&](const Eigen::VectorXd &s) -> Eigen::VectorXd {
    return fixed_point + r * (s.array() - fixed_point);
  };
  stiction::qp::ComponentwiseSecant secant;
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(4);
  const Eigen::VectorXd first = secant.next(start, S(start));
  const Eigen::VectorXd next  = secant.next(first, S(first));
  std::cout << "first step is S: " << (first == S(start) ? "yes" : "NO")
            << "\nerrors after the secant: "
            << (next.array() - fixed_point).head<2>().abs().maxCoeff()
            << "\ncreeps: " << (next(2) - first(2)) / (S(first)(2) - first(2))
            << " steps\nsteps grow: " << (next(3) - first(3)) / (S(first)(3) - first(3))
            << " steps" << std::endl;
}
