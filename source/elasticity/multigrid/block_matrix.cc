#include "block_matrix.h"

#include <algorithm>
#include <limits>

namespace stiction
{
  namespace
  {
    constexpr unsigned int none = std::numeric_limits<unsigned int>::max();
  } // namespace

  template<typename Callback>
  void BlockMatrix::for_each_block(const Callback &callback) const
  {
    for (unsigned int i = 0; i + 1 < begin_.size(); ++i)
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
        callback(k, i, columns_[k]);
  }

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
            if (j < i && row_of[j] != i)
              {
                row_of[j] = i;
                columns_.push_back(j);
              }
        columns_.push_back(i);
        std::sort(columns_.begin() + static_cast<std::ptrdiff_t>(begin_[i]),
                  columns_.end());
        begin_[i + 1] = columns_.size();
      }
    sums_.assign(9 * columns_.size() + 1, 0.);
  }

  BlockMatrix::BlockMatrix(const BlockMatrix &A, const Interpolation &P)
    : begin_(static_cast<std::size_t>(P.cols()) + 1, 0)
  {
    // all blocks of the rows of A: the column, and the place of it or its transpose
    struct Entry
    {
      unsigned int column;
      bool is_transposed;
      std::size_t place;
    };
    std::vector<std::vector<Entry>> rows(static_cast<std::size_t>(A.n()));
    A.for_each_block(
      [&](const std::size_t k, const unsigned int i, const unsigned int j) {
        rows[i].push_back({j, false, k});
        if (j != i)
          rows[j].push_back({i, true, k});
      });

    const Interpolation restriction = P.transpose();
    const auto n                    = static_cast<unsigned int>(P.cols());
    std::vector<unsigned int> row_of(n, none); // the last row that has the column
    std::vector<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> row(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto reach = [&](const unsigned int j) {
          if (row_of[j] != i)
            {
              row_of[j] = i;
              row[j].setZero();
              columns_.push_back(j);
            }
        };
        for (Interpolation::InnerIterator r(restriction, i); r; ++r)
          for (const Entry &entry : rows[r.col()])
            for (Interpolation::InnerIterator p(P, entry.column); p; ++p)
              if (const auto j = static_cast<unsigned int>(p.col()); j <= i)
                {
                  reach(j);
                  const double weight = static_cast<double>(r.value()) * p.value();
                  if (entry.is_transposed)
                    row[j] += weight * A.block(entry.place).transpose().cast<double>();
                  else
                    row[j] += weight * A.block(entry.place).cast<double>();
                }
        reach(i);
        const auto first = columns_.begin() + static_cast<std::ptrdiff_t>(begin_[i]);
        std::sort(first, columns_.end());
        for (auto j = first; j != columns_.end(); ++j)
          blocks_.insert(blocks_.end(), row[*j].data(), row[*j].data() + 9);
        begin_[i + 1] = columns_.size();
      }
    blocks_.push_back(0.f);
  }

  void BlockMatrix::add(const Entries &entries)
  {
    for (std::size_t a = 0; a < entries.vertices.size(); ++a)
      {
        std::size_t place = begin_[entries.vertices[a]];
        for (std::size_t b = 0; b <= a; ++b, ++place)
          {
            while (columns_[place] != entries.vertices[b])
              ++place;
            const double *const from = &entries.blocks(static_cast<Eigen::Index>(9 * a),
                                                       static_cast<Eigen::Index>(b));
            double *const to         = &sums_[9 * place];
            for (unsigned int k = 0; k < 9; ++k)
              to[k] += from[k];
          }
      }
  }

  void BlockMatrix::end_of_sums()
  {
    blocks_.assign(sums_.begin(), sums_.end());
    sums_ = {};
  }

  void BlockMatrix::vmult(BlockVector &y, const BlockVector &x) const
  {
    using Four      = Eigen::Vector4f;
    const auto four = [](const float *const numbers) {
      return Four(Eigen::Map<const Four>(numbers));
    };
    padded_x_.setZero(n(), 4);
    padded_x_.leftCols<3>() = x;
    padded_y_.setZero(n(), 4);
    // rows of blocks with the first number of the next row: it meets a zero of x, and
    // what it adds to y is dropped
    for (Eigen::Index i = 0; i < n(); ++i)
      {
        const Four own = padded_x_.row(i);
        std::array<Four, 3> sums{{Four::Zero(), Four::Zero(), Four::Zero()}};
        Four to_column = Four::Zero();
        for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
          {
            const float *const block = &blocks_[9 * k];
            const std::array<Four, 3> rows{
              {four(block), four(block + 3), four(block + 6)}};
            const Eigen::Index j = columns_[k];
            to_column            = own[0] * rows[0] + own[1] * rows[1] + own[2] * rows[2];
            if (j == i)
              break;
            const Four other = padded_x_.row(j);
            for (unsigned int a = 0; a < 3; ++a)
              sums[a] += rows[a].cwiseProduct(other);
            padded_y_.row(j) += to_column.transpose();
          }
        padded_y_.row(i) +=
          (to_column + Four(sums[0].sum(), sums[1].sum(), sums[2].sum(), 0.f))
            .transpose();
      }
    y = padded_y_.leftCols<3>();
  }

  BlockMatrix::Block BlockMatrix::diagonal_block(const Eigen::Index i) const
  {
    return block(begin_[i + 1] - 1);
  }

  BlockVector BlockMatrix::off_diagonal_sums() const
  {
    BlockVector sums = BlockVector::Zero(n(), 3);
    for_each_block([&](const std::size_t k, const unsigned int i, const unsigned int j) {
      const Block sizes = block(k).cwiseAbs();
      sums.row(i) += sizes.rowwise().sum().transpose();
      if (j == i)
        sums.row(i) -= sizes.diagonal().transpose();
      else
        sums.row(j) += sizes.colwise().sum();
    });
    return sums;
  }

  Eigen::MatrixXf BlockMatrix::dense() const
  {
    Eigen::MatrixXf matrix = Eigen::MatrixXf::Zero(3 * n(), 3 * n());
    for_each_block([&](const std::size_t k, const Eigen::Index i, const Eigen::Index j) {
      matrix.block<3, 3>(3 * i, 3 * j) = block(k);
      matrix.block<3, 3>(3 * j, 3 * i) = block(k).transpose();
    });
    return matrix;
  }
} // namespace stiction
