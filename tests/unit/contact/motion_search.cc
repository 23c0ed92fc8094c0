// Multipliers of the balance of a body: of a linear map the fixed point is found in as
// many steps as there are multipliers and two more, however slowly the map contracts; of
// one with a kink it is found as well.

#include <stiction/contact/dual/motion_search.h>

#include "tests.h"

#include <Eigen/LU>

#include <cmath>

using namespace stiction;

namespace
{
  template<typename Map>
  void check(const std::string &name, const Eigen::VectorXd &fixed, const Map &map,
             const unsigned int n_steps)
  {
    MotionSearch search;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(fixed.size()), plain = x;
    for (unsigned int k = 0; k < n_steps; ++k)
      {
        x     = search.next(x, map(x));
        plain = map(plain);
      }
    out() << name << ": found " << yes((x - fixed).norm() < 1e-8 * fixed.norm())
          << ", without the search "
          << ((plain - fixed).norm() < 1e-8 * fixed.norm() ? "as well" : "not")
          << std::endl;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Eigen::Index n = 6;
  Eigen::VectorXd fixed(n), rates(n);
  fixed << 1., -2., 3., 0.5, -1., 2.;
  rates << 0.99, 0.9, 0.7, 0.5, 0.2, 0.01;
  Eigen::MatrixXd basis(n, n); // not orthogonal
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      basis(i, j) = std::cos(static_cast<double>(1 + i * j) + static_cast<double>(i));
  const Eigen::MatrixXd A = basis * rates.asDiagonal() * basis.inverse();
  check(
    "linear", fixed,
    [&](const Eigen::VectorXd &x) -> Eigen::VectorXd { return fixed + A * (x - fixed); },
    8);
  check(
    "one number", fixed.head(1),
    [&](const Eigen::VectorXd &x) -> Eigen::VectorXd {
      return fixed.head(1) + 0.99 * (x - fixed.head(1));
    },
    3);
  check(
    "with a kink", fixed,
    [&](const Eigen::VectorXd &x) -> Eigen::VectorXd {
      const Eigen::VectorXd y = A * (x - fixed);
      return fixed + y + 0.3 * (y.cwiseAbs() - y);
    },
    40);
}
