#pragma once

#include <Eigen/Core>

namespace stiction::qp
{
  /// A step of non-negative least squares (C. L. Lawson and R. J. Hanson, Solving Least
  /// Squares Problems, 1974, chapter 23): the amounts c >= 0 of columns for which A c is
  /// as near to b as they can bring it.
  ///
  /// @param amounts in: the best ones without the last column, which is new, gains, and
  ///   has the amount 0; out: zero for columns of no use.
  void find_amounts(const Eigen::MatrixXd &A, const Eigen::VectorXd &b,
                    Eigen::VectorXd &amounts);
} // namespace stiction::qp
