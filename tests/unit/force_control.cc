// The search for the places where obstacles press with prescribed forces, on
// bodies that are formulas: the force is met to the tolerance within few
// trials whatever the law between distance and force, from starts that are
// wrong by six powers of ten; obstacles that act on each other; a force that
// cannot be reached is given up with a reason.

#include "tests.h"

#include <stiction/contact/obstacles/force_control.h>

#include <Eigen/LU>

#include <cmath>
#include <functional>

using namespace stiction;
using Eigen::VectorXd;

namespace
{
  using Forces = std::function<VectorXd(const VectorXd &)>;

  // Trials until every force is the prescribed one, 2, -1 if the search gave
  // up. Without forces
  // there is contact where the distance is touch + contact.
  int trials(const Forces &forces, const VectorXd &touch, const double reach,
             const double tolerance, const double contact = 0., const double scale = 2.,
             VectorXd prescribed = VectorXd())
  {
    const Eigen::Index n = touch.size();
    if (prescribed.size() == 0)
      prescribed = VectorXd::Constant(n, 2.);
    ForceControl control(prescribed, {touch, VectorXd::Constant(n, reach), 1e3});
    ForceControl::Outcome outcome;
    // a solve that is as wrong as it may be
    int sign                 = 1;
    const std::string reason = control.press(
      [&](const double accuracy) {
        sign = -sign;
        outcome.forces =
          (forces(control.distances()).array() + 0.3 * sign * accuracy * scale).max(0.);
        outcome.force_scale = scale;
        outcome.clearance =
          (touch.array() + contact - control.distances().array()).max(0.);
        return outcome;
      },
      tolerance, 0.1 * tolerance);
    const bool is_met =
      ((forces(control.distances()).array() / prescribed.array() - 1.).abs() <=
       1.1 * tolerance)
        .all();
    if (is_met != reason.empty())
      return -2;
    return is_met ? static_cast<int>(control.n_trials()) : -1;
  }

  VectorXd one(const double value)
  {
    return VectorXd::Constant(1, value);
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // a power of the distance beyond 0.3: springs, flat punch, sphere, cone
  for (const double power : {0.5, 1., 1.5, 2., 3.})
    for (const double reach : {1e-6, 1e-3, 1., 1e3})
      {
        const int n = trials(
          [&](const VectorXd &d) {
            return one(3e3 * std::pow(std::max(d(0) - 0.3, 0.), power));
          },
          one(0.3), reach, 2e-9);
        out() << "power " << power << ", first reach " << reach
              << ": met within 20 trials " << yes(n > 0 && n <= 20);
        if (reach == 1e-3)
          out() << ", within 15 " << yes(n <= 15);
        out() << '\n';
      }

  out() << "begins away from a body that has given way: "
        << yes(
             trials([](const VectorXd &d) { return one(50. * std::max(d(0) - 4., 0.)); },
                    one(0.3), 0.01, 1e-9, 3.7) > 0)
        << '\n';
  out() << "small beside other forces: "
        << yes(trials(
                 [](const VectorXd &d) {
                   return one(50. * std::pow(std::max(d(0), 0.), 1.5));
                 },
                 one(0.), 0.01, 1e-9, 0., 1e5) > 0)
        << '\n';
  out() << "begins in a body that presses by itself: "
        << yes(trials([](const VectorXd &d) { return one(50. + 3. * d(0)); }, one(0.),
                      0.1, 1e-9) > 0)
        << '\n';
  out() << "a kink: "
        << yes(trials(
                 [](const VectorXd &d) {
                   return one(d(0) < 1. ? 1e-2 * d(0) : 1e-2 + 1e3 * (d(0) - 1.));
                 },
                 one(0.), 1e-3, 1e-8) > 0)
        << '\n';

  Eigen::MatrixXd K(3, 3);
  K << 9., -4., -2., -4., 8., -3., -2., -3., 7.;
  const auto coupled = [&](const VectorXd &d) {
    return VectorXd(
      (K * d.unaryExpr([](double x) { return std::pow(std::max(x, 0.), 1.2); }))
        .cwiseMax(0.));
  };
  const int n = trials(coupled, VectorXd::Zero(3), 0.1, 1e-9);
  out() << "three that act on each other: within 40 trials " << yes(n > 0 && n <= 40)
        << '\n';

  const int m =
    trials(coupled, VectorXd::Zero(3), 0.1, 1e-9, 0., 2., Eigen::Vector3d(200., 0.5, 2.));
  out() << "unlike forces: within 60 trials " << yes(m > 0 && m <= 60) << '\n';

  out() << "a force that stays below: given up "
        << yes(trials(
                 [](const VectorXd &d) {
                   return one(1.9 * (1. - std::exp(-std::max(d(0), 0.))));
                 },
                 one(0.), 0.1, 1e-9) == -1)
        << '\n';
  out() << "no number: given up "
        << yes(trials([](const VectorXd &) { return one(std::nan("")); }, one(0.), 0.1,
                      1e-9) == -1)
        << '\n';
}
