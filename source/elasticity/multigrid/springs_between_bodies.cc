#include "springs_between_bodies.h"

#include <stiction/elasticity/linear_algebra/sorted_list.h>

#include <map>

namespace stiction
{
  namespace
  {
    using Interpolation = BackgroundMultigrid::Interpolation;

    // Of the largest weight of a slave.
    constexpr double small = 1e-2;
  } // namespace

  BackgroundMultigrid::SpringsBetweenBodies::SpringsBetweenBodies(
    const BasisTransformation &basis, const Interpolation &to_nodes,
    const std::vector<std::vector<unsigned int>> &touched,
    const std::vector<Interpolation> &grids)
    : of_slave_(basis.slaves().size())
    , n_touched_(touched.front().size())
  {
    for (std::size_t i = 0; i < of_slave_.size(); ++i)
      {
        const auto opposite = basis.large_blocks_of(i, small);
        if (opposite.empty())
          continue;
        std::map<unsigned int, Eigen::Matrix3f> blocks;
        const auto add = [&](const Eigen::Index node, const Eigen::Matrix3f &factor) {
          for (Interpolation::InnerIterator entry(to_nodes, node); entry; ++entry)
            blocks
              .try_emplace(place_in(touched.front(), entry.col()),
                           Eigen::Matrix3f::Zero())
              .first->second += entry.value() * factor;
        };
        add(static_cast<Eigen::Index>(i), Eigen::Matrix3f::Identity());
        for (const auto &[j, N] : opposite)
          add(static_cast<Eigen::Index>(of_slave_.size()) + j, -N.cast<float>());
        of_slave_[i].assign(blocks.begin(), blocks.end());
      }
    for (std::size_t g = 1; g < grids.size(); ++g)
      {
        std::vector<Eigen::Triplet<float>> entries;
        for (std::size_t i = 0; i < touched[g - 1].size(); ++i)
          for (Interpolation::InnerIterator entry(grids[g], touched[g - 1][i]); entry;
               ++entry)
            entries.emplace_back(i, place_in(touched[g], entry.col()), entry.value());
        to_finer_.emplace_back(static_cast<Eigen::Index>(touched[g - 1].size()),
                               static_cast<Eigen::Index>(touched[g].size()));
        to_finer_.back().setFromTriplets(entries.begin(), entries.end());
      }
  }

  std::vector<BlockMatrix> BackgroundMultigrid::SpringsBetweenBodies::on_grids(
    const std::vector<Eigen::Matrix3f> &S) const
  {
    std::vector<std::size_t> slaves; // with springs, and their vertices
    std::vector<std::vector<unsigned int>> sets;
    for (std::size_t i = 0; i < of_slave_.size(); ++i)
      if (has(i) && !S[i].isZero(0.f))
        {
          slaves.push_back(i);
          sets.emplace_back();
          for (const auto &[vertex, block] : of_slave_[i])
            sets.back().push_back(vertex);
        }
    std::vector<BlockMatrix> matrices;
    matrices.reserve(1 + to_finer_.size());
    matrices.emplace_back(n_touched_, sets);
    BlockMatrix::Entries entries;
    for (std::size_t s = 0; s < slaves.size(); ++s)
      {
        const std::size_t i = slaves[s];
        const Row &row      = of_slave_[i];
        const auto n        = static_cast<Eigen::Index>(row.size());
        entries.vertices    = std::move(sets[s]);
        entries.blocks.resize(9 * n, n);
        for (Eigen::Index a = 0; a < n; ++a)
          {
            const Eigen::Matrix3f force = row[a].second.transpose() * S[i];
            for (Eigen::Index b = 0; b <= a; ++b)
              {
                Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> block(
                  &entries.blocks(9 * a, b));
                block = (force * row[b].second).cast<double>();
              }
          }
        matrices.front().add(entries);
      }
    matrices.front().end_of_sums();
    for (const Interpolation &P : to_finer_)
      matrices.emplace_back(matrices.back(), P);
    return matrices;
  }
} // namespace stiction
