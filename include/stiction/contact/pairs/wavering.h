#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace stiction
{
  /// The part of tractions that wavers from node to node without the other side feeling
  /// it, sums of norms: what is left of them beside their means over what a node opposite
  /// feels of them, interpolated back.
  ///
  /// @param weights of the nodes opposite at each node, m × n
  /// @param forces, areas m × 3 and m, N and m²: zero at nodes to leave out
  double wavering(const Eigen::SparseMatrix<double, Eigen::RowMajor> &weights,
                  const Eigen::MatrixX3d &forces, const Eigen::VectorXd &areas);
} // namespace stiction
