#include "block_matrix.h"

#include <algorithm>
#include <limits>

namespace stiction
{
  namespace
  {
    constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

    Eigen::Map<const Eigen::Matrix3f> block_at(const std::vector<float> &blocks,
                                               const std::size_t k)
    {
      return Eigen::Map<const Eigen::Matrix3f>(&blocks[9 * k]);
    }
  } // namespace

  BlockMatrix::BlockMatrix(const std::size_t n,
                           const std::vector<std::vector<unsigned int>> &sets)
    : begin_(n + 1, 0)
  {
    std::vector<std::vector<unsigned int>> sets_at(n);
    for (unsigned int s = 0; s < sets.size(); ++s)
      for (const unsigned int i : sets[s])
        sets_at[i].push_back(s);
    std::vector<unsigned int> row_of(n, none); // the last row that has the column
    for (unsigned int i = 0; i < n; ++i)
      {
        for (const unsigned int s : sets_at[i])
          for (const unsigned int j : sets[s])
            if (row_of[j] != i)
              {
                row_of[j] = i;
                columns_.push_back(j);
              }
        begin_[i + 1] = columns_.size();
        std::sort(columns_.begin() + static_cast<std::ptrdiff_t>(begin_[i]),
                  columns_.end());
      }
    blocks_.assign(9 * columns_.size(), 0.f);
  }

  BlockMatrix::BlockMatrix(const BlockMatrix &A, const Interpolation &P)
    : begin_(static_cast<std::size_t>(P.cols()) + 1, 0)
  {
    const Interpolation restriction = P.transpose();
    const auto n                    = static_cast<unsigned int>(P.cols());
    std::vector<std::size_t> place(n); // of a column in the row that is made
    std::vector<unsigned int> row_of(n, none);
    for (unsigned int i = 0; i < n; ++i)
      {
        for (Interpolation::InnerIterator r(restriction, i); r; ++r)
          for (std::size_t k = A.begin_[r.col()]; k < A.begin_[r.col() + 1]; ++k)
            for (Interpolation::InnerIterator p(P, A.columns_[k]); p; ++p)
              {
                const auto j = static_cast<unsigned int>(p.col());
                if (row_of[j] != i)
                  {
                    row_of[j] = i;
                    place[j]  = columns_.size();
                    columns_.push_back(j);
                    blocks_.resize(9 * columns_.size(), 0.f);
                  }
                Eigen::Map<Eigen::Matrix3f>(&blocks_[9 * place[j]]) +=
                  (r.value() * p.value()) * block_at(A.blocks_, k);
              }
        begin_[i + 1] = columns_.size();
      }
  }

  void BlockMatrix::add(const Entries &entries)
  {
    for (std::size_t a = 0; a < entries.vertices.size(); ++a)
      {
        const unsigned int row = entries.vertices[a];
        const auto first = columns_.begin() + static_cast<std::ptrdiff_t>(begin_[row]);
        const auto last = columns_.begin() + static_cast<std::ptrdiff_t>(begin_[row + 1]);
        for (std::size_t b = 0; b < entries.vertices.size(); ++b)
          {
            const auto place = static_cast<std::size_t>(
              std::lower_bound(first, last, entries.vertices[b]) - columns_.begin());
            const float *const from =
              entries.blocks.data() +
              static_cast<std::size_t>(entries.blocks.cols()) * a + 9 * b;
            for (unsigned int k = 0; k < 9; ++k)
              blocks_[9 * place + k] += from[k];
          }
      }
  }

  void BlockMatrix::vmult(BlockVector &y, const BlockVector &x) const
  {
    y.resize(n(), 3);
    for (Eigen::Index i = 0; i < n(); ++i)
      {
        float sum[3] = {0.f, 0.f, 0.f};
        for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
          {
            const float *const block = &blocks_[9 * k];
            const float *const at    = x.data() + 3 * std::size_t(columns_[k]);
            for (unsigned int a = 0; a < 3; ++a)
              sum[a] += block[a] * at[0] + block[3 + a] * at[1] + block[6 + a] * at[2];
          }
        for (unsigned int a = 0; a < 3; ++a)
          y(i, a) = sum[a];
      }
  }

  BlockMatrix::Block BlockMatrix::diagonal_block(const Eigen::Index i) const
  {
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
      if (columns_[k] == i)
        return block_at(blocks_, k);
    return Block::Zero();
  }

  BlockVector BlockMatrix::off_diagonal_sums() const
  {
    BlockVector sums = BlockVector::Zero(n(), 3);
    for (Eigen::Index i = 0; i < n(); ++i)
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
        {
          sums.row(i) += block_at(blocks_, k).cwiseAbs().rowwise().sum().transpose();
          if (columns_[k] == i)
            sums.row(i) -= block_at(blocks_, k).diagonal().cwiseAbs().transpose();
        }
    return sums;
  }

  Eigen::MatrixXf BlockMatrix::dense() const
  {
    Eigen::MatrixXf matrix = Eigen::MatrixXf::Zero(3 * n(), 3 * n());
    for (Eigen::Index i = 0; i < n(); ++i)
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
        matrix.block<3, 3>(3 * i, 3 * Eigen::Index(columns_[k])) = block_at(blocks_, k);
    return matrix;
  }
} // namespace stiction
