#pragma once

#include <deal.II/lac/full_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace stiction
{
  /// The stiffness matrix as a sum of element matrices that are kept: for elements and
  /// materials that CellStiffness does not integrate. Cells that follow each other with
  /// the same matrix share it.
  ///
  /// Vectors are arrays of three numbers a node, entry 3·node + component.
  ///
  /// @tparam Number float or double
  template<typename Number> class ElementMatrices
  {
  public:
    /// A cell by its nodes, as many as all others have, and its matrix, node by node.
    void add(const std::vector<unsigned int> &nodes,
             const dealii::FullMatrix<double> &matrix);

    bool empty() const { return cells_.empty(); }

    /// dst += K src. The arrays must not overlap.
    void add_product(Number *dst, const Number *src) const;

    /// Adds the 3×3 block of each node on the diagonal of K:
    /// dst[9·node + 3·row + column] += K(3·node + row, 3·node + column).
    void add_diagonal_blocks(Number *dst) const;

  private:
    using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;

    std::size_t n_nodes() const { return static_cast<std::size_t>(last_.m()) / 3; }

    std::vector<unsigned int> cells_; ///< the nodes of each
    std::vector<Matrix> matrices_;
    std::vector<std::size_t> ends_; ///< of the cells with each matrix
    dealii::FullMatrix<double> last_;
  };
} // namespace stiction
