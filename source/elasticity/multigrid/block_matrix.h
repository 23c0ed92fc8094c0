#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace stiction
{
  /// Three numbers a vertex, a row each.
  using BlockVector = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

  /// A symmetric sparse matrix of 3 × 3 blocks in single precision. Blocks above the
  /// diagonal are not kept: a product is as fast as what it reads.
  class BlockMatrix
  {
  public:
    using Interpolation = Eigen::SparseMatrix<float, Eigen::RowMajor>;
    using Block         = Eigen::Matrix<float, 3, 3, Eigen::RowMajor>;

    /// A dense symmetric matrix at some rows and columns, to be added.
    struct Entries
    {
      std::vector<unsigned int> vertices; ///< by number
      /// Row 9i + 3a + b, column j: entry (a, b) of block (i, j), for j ≤ i.
      Eigen::MatrixXd blocks;
    };

    /// Zero, with room where any of these sets of vertices meet.
    BlockMatrix(std::size_t n, const std::vector<std::vector<unsigned int>> &sets);

    /// Pᵀ A P.
    BlockMatrix(const BlockMatrix &A, const Interpolation &P);

    Eigen::Index n() const { return static_cast<Eigen::Index>(begin_.size()) - 1; }

    /// Before end_of_sums(): they are kept in double precision. What single precision
    /// leaves of many equal terms is enough to hold a stiff body that only soft ones
    /// hold.
    void add(const Entries &entries);

    void end_of_sums();

    /// y = A x.
    void vmult(BlockVector &y, const BlockVector &x) const;

    Block diagonal_block(Eigen::Index i) const;

    /// Σ_j |A_ij| over the entries of the rows, but for those on the diagonal.
    BlockVector off_diagonal_sums() const;

    /// The matrix, row 3i + a being component a of vertex i.
    Eigen::MatrixXf dense() const;

  private:
    /// Calls back with the place of each block, its row and its column.
    template<typename Callback> void for_each_block(const Callback &callback) const;

    Eigen::Map<const Block> block(const std::size_t place) const
    {
      return Eigen::Map<const Block>(&blocks_[9 * place]);
    }

    std::vector<std::size_t> begin_;
    std::vector<unsigned int> columns_; ///< sorted in each row, the last is the row
    std::vector<double> sums_;          ///< as blocks_, until they are complete
    std::vector<float> blocks_;         ///< nine numbers each, by rows, one to spare

    /// Vectors four numbers a vertex, as registers have them.
    using PaddedVector = Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor>;
    mutable PaddedVector padded_x_, padded_y_;
  };
} // namespace stiction
