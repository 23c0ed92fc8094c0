// What is seen of a surface that moves as a rigid body: random nodes see what a body that
// they belong to as well would do, wherever they are; where they are where the weights
// say, they see what the weights say; nodes in a line say nothing of turns about it.

#include <stiction/contact/pairs/rigid_turn.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include "../../random_numbers.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iostream>
#include <vector>

using namespace stiction;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

namespace
{
  constexpr Index m = 5, n = 7;

  MatrixXd random_matrix(RandomNumbers &random, const Index rows, const Index columns,
                         const double smallest)
  {
    return MatrixXd::NullaryExpr(rows, columns,
                                 [&]() { return random.uniform(smallest, 1.); });
  }

  VectorXd moved(const VectorXd &positions, const Vector3d &way, const Vector3d &turn)
  {
    VectorXd u(positions.size());
    for (Index i = 0; i < u.size() / 3; ++i)
      set_at_node(u, i, way + turn.cross(at_node(positions, i)));
    return u;
  }

  MatrixXd by_blocks(const MatrixXd &weights)
  {
    MatrixXd all = MatrixXd::Zero(3 * m, 3 * n);
    for (Index c = 0; c < 3; ++c)
      all.block(c * m, c * n, m, n) = weights;
    return all;
  }
} // namespace

int main()
{
  RandomNumbers random(5);
  const std::vector<unsigned int> surfaces(m, 0);
  double rigid = 0., without = 0., in_line = 0., about_line = 0.;
  for (unsigned int k = 0; k < 50; ++k)
    {
      MatrixXd weights        = random_matrix(random, m, n, -0.2);
      const MatrixXd overlaps = random_matrix(random, m, n, 0.1);
      weights.array().colwise() /= weights.rowwise().sum().array().eval();
      const Matrix A = weights.sparseView(), W = overlaps.sparseView();
      const VectorXd places = random_matrix(random, 3 * m, 1, -1.);
      VectorXd opposite     = random_matrix(random, 3 * n, 1, -1.);
      const Vector3d way    = random_matrix(random, 3, 1, -1.);
      const Vector3d turn   = random_matrix(random, 3, 1, -1.);

      const auto error_of = [&](const Vector3d &turned) -> double {
        return (with_rigid_turns(A, W, places, opposite, surfaces) *
                  moved(opposite, way, turned) -
                moved(places, way, turned))
          .norm();
      };
      rigid = std::max(rigid, error_of(turn));
      without =
        std::max(without, (MatrixXd(with_rigid_turns(A, W, by_blocks(weights) * opposite,
                                                     opposite, surfaces)) -
                           by_blocks(weights))
                            .norm());
      opposite.tail(2 * n).setZero(); // along x
      in_line    = std::max(in_line, error_of({0., turn(1), turn(2)}));
      about_line = std::max(about_line, error_of({1., 0., 0.}));
    }

  // the first two nodes face the first three opposite, the others the other ones
  MatrixXd apart = MatrixXd::Zero(m, n);
  apart.topLeftCorner(2, 3).setConstant(1. / 3.);
  apart.bottomRightCorner(m - 2, n - 3).setConstant(1. / (n - 3.));
  const Matrix W        = apart.sparseView();
  const VectorXd places = random_matrix(random, 3 * m, 1, -1.);
  VectorXd opposite     = random_matrix(random, 3 * n, 1, -1.);
  const auto mixed      = [&](const std::vector<unsigned int> &numbers) {
    const MatrixXd A(with_rigid_turns(W, W, places, opposite, numbers));
    double sum = 0.;
    for (Index r = 0; r < 3; ++r)
      for (Index c = 0; c < 3; ++c)
        sum += A.block(r * m, c * n + 3, 2, n - 3).norm();
    return sum;
  };
  opposite.array() += 10.;
  const double of_one = mixed(surfaces), of_two = mixed({0, 0, 1, 1, 1});

  const auto yes = [](const bool is_so) { return is_so ? "yes" : "no"; };
  std::cout << "rigid motions to 1e-12 " << yes(rigid < 1e-12)
            << "\nweights alone where they are enough " << yes(without < 1e-12)
            << "\nin a line: turns across to 1e-12 " << yes(in_line < 1e-12)
            << ", not about it " << yes(about_line > 0.1)
            << "\nacross a wide gap nodes of a surface see what its others do "
            << yes(of_one > 0.1) << ", not those of another one " << yes(of_two == 0.)
            << std::endl;
}
