#pragma once

#include "block_matrix.h"

#include <stiction/elasticity/multigrid/background_multigrid.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace stiction
{
  /// Springs at nodes that have another body opposite, as matrices of the vertices of the
  /// grids that may have springs, by their places in Grid::touched(). The same on all
  /// ranks.
  class BackgroundMultigrid::SpringsBetweenBodies
  {
  public:
    /// @param to_nodes the slaves and behind them the masters, from the first grid.
    /// @param touched of all grids. @param grids their interpolations to the finer ones.
    SpringsBetweenBodies(const BasisTransformation &basis, const Interpolation &to_nodes,
                         const std::vector<std::vector<unsigned int>> &touched,
                         const std::vector<Interpolation> &grids);

    /// Whether node i of the list has something opposite.
    bool has(const std::size_t i) const { return !of_slave_[i].empty(); }

    /// The matrix on each grid, with the spring S of each slave.
    std::vector<BlockMatrix> on_grids(const std::vector<Eigen::Matrix3f> &S) const;

  private:
    /// B P of a slave: its blocks, by vertices in order.
    using Row = std::vector<std::pair<unsigned int, Eigen::Matrix3f>>;

    std::vector<Row> of_slave_;
    std::vector<Interpolation> to_finer_; ///< of touched vertices alone, from the second
    std::size_t n_touched_;               ///< on the first grid
  };
} // namespace stiction
