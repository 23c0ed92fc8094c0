#include "slave_blocks.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace stiction
{
  using Blocks = BasisTransformation::Blocks;
  using Matrix = BasisTransformation::Matrix;

  namespace
  {
    // Rows with fewer cost nothing.
    constexpr std::size_t many_blocks = 100;
  } // namespace

  Blocks blocks_of(const Matrix &N, const Eigen::Index slave)
  {
    Blocks blocks;
    for (Eigen::Index a = 0; a < 3; ++a)
      for (Matrix::InnerIterator entry(N, 3 * slave + a); entry; ++entry)
        blocks.try_emplace(entry.col() / 3, Eigen::Matrix3d::Zero())
          .first->second(a, entry.col() % 3) = entry.value();
    return blocks;
  }

  Blocks large_blocks(Blocks blocks, const double part)
  {
    const auto size = [](const Eigen::Matrix3d &N) { return N.cwiseAbs().maxCoeff(); };
    const auto largest =
      std::max_element(blocks.begin(), blocks.end(), [&](const auto &a, const auto &b) {
        return size(a.second) < size(b.second);
      });
    Eigen::Matrix3d left_out = Eigen::Matrix3d::Zero();
    for (auto b = blocks.begin(); b != blocks.end();)
      if (size(b->second) < part * size(largest->second))
        {
          left_out += b->second;
          b = blocks.erase(b);
        }
      else
        ++b;
    if (!blocks.empty())
      largest->second += left_out;
    return blocks;
  }

  Matrix without_small_blocks(const Matrix &N, const double part)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < N.rows() / 3; ++i)
      {
        Blocks blocks = blocks_of(N, i);
        if (blocks.size() > many_blocks)
          blocks = large_blocks(std::move(blocks), part);
        for (const auto &[j, block] : blocks)
          for (Eigen::Index a = 0; a < 3; ++a)
            for (Eigen::Index b = 0; b < 3; ++b)
              if (block(a, b) != 0.)
                entries.emplace_back(3 * i + a, 3 * j + b, block(a, b));
      }
    Matrix large(N.rows(), N.cols());
    large.setFromTriplets(entries.begin(), entries.end());
    return large;
  }
} // namespace stiction
