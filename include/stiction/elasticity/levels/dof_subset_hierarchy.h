#pragma once

#include <deal.II/base/types.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace stiction
{
  class MeshHierarchy;

  /// A list of nodes on the mesh, known to all ranks, followed through the
  /// levels: a coarser level has those that are its vertices, in the same
  /// order.
  class DofSubsetHierarchy
  {
  public:
    /// @param first_dofs the first unknown of each node of the list on the
    ///   mesh itself. Collective.
    DofSubsetHierarchy(const MeshHierarchy &hierarchy,
                       const std::vector<dealii::types::global_dof_index> &first_dofs);

    /// The first unknowns of the nodes on a level.
    const std::vector<dealii::types::global_dof_index> &first_dofs(
      const unsigned int level) const
    {
      return first_dofs_[level];
    }

    /// Where in the list of the next finer level the nodes of this one are.
    const std::vector<Eigen::Index> &on_finer_level(const unsigned int level) const
    {
      return on_finer_level_[level];
    }

    /// The interpolation from the list of level − 1 to that of a level > 0, a
    /// row a fine node; coarse nodes outside of the list are left out.
    const Eigen::SparseMatrix<double> &prolongation(const unsigned int level) const
    {
      return prolongation_[level - 1];
    }

  private:
    std::vector<std::vector<dealii::types::global_dof_index>> first_dofs_;
    std::vector<std::vector<Eigen::Index>> on_finer_level_;
    std::vector<Eigen::SparseMatrix<double>> prolongation_;
  };
} // namespace stiction
