#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace stiction
{
  /// Â: what the nodes of one surface see of the displacement of another one, such that
  /// both can turn together. Weights W alone keep translations, but rotations only where
  /// x = Σ_j W_ij x_j, not across a gap or where facets stand apart. There the surface
  /// opposite is carried on to x as a rigid body,
  ///
  ///     (Âu)(x_i) = Σ_j W_ij u_j + ω_i × d_i,   d_i = x_i − Σ_j W_ij x_j,
  ///
  /// ω_i the rotation that fits the u_j opposite best in the sense of least squares,
  /// weighted with the overlaps of the node and of those of its surface that are nearer
  /// than |d_i|, up to some hundred nodes. With that, forces λ on the slave and −Âᵀλ on
  /// the other side have no moment (M. A. Puso, T. A. Laursen, A mortar
  /// segment-to-segment contact method for large deformation solid mechanics, 2004, on
  /// why it matters).
  ///
  /// @param weights W, m × n, whose rows sum to 1.
  /// @param overlaps ∫ |φ_i φ_j| of the shape functions of both, above zero for more than
  ///   a line of nodes j.
  /// @param positions, opposite of the nodes of both, in m, by blocks (x; y; z).
  /// @param surfaces the number of the surface that each node belongs to, length m.
  /// @return 3m × 3n, by blocks. Rows whose d_i is rounding hold the weights alone.
  Eigen::SparseMatrix<double, Eigen::RowMajor> with_rigid_turns(
    const Eigen::SparseMatrix<double, Eigen::RowMajor> &weights,
    const Eigen::SparseMatrix<double, Eigen::RowMajor> &overlaps,
    const Eigen::VectorXd &positions, const Eigen::VectorXd &opposite,
    const std::vector<unsigned int> &surfaces);
} // namespace stiction
