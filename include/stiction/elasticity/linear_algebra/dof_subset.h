#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/types.h>

#include <Eigen/Core>

#include <vector>

namespace stiction
{
  /// A list of unknowns, known to all ranks, and the passage between
  /// distributed vectors and the values at these unknowns, which every rank
  /// holds in full.
  class DofSubset
  {
  public:
    DofSubset() = default;
    explicit DofSubset(std::vector<dealii::types::global_dof_index> dofs);

    /// The three unknowns of each node, by blocks (x; y; z).
    ///
    /// @param first_dofs those for x; y and z follow.
    static DofSubset of_nodes(
      const std::vector<dealii::types::global_dof_index> &first_dofs);

    /// The three unknowns of each node, node by node.
    static DofSubset node_by_node(
      const std::vector<dealii::types::global_dof_index> &first_dofs);

    Eigen::Index size() const { return static_cast<Eigen::Index>(dofs_.size()); }

    const std::vector<dealii::types::global_dof_index> &dofs() const { return dofs_; }

    /// The entries of u at the unknowns of the list, on every rank. Each has
    /// one owner, so the result is the same to the last bit on all ranks.
    /// Collective.
    template<typename Number>
    Eigen::VectorXd restriction(const LA::VectorOf<Number> &u) const;

    /// Adds values to the entries of dst at the unknowns of the list, of which each rank
    /// takes those that it owns.
    template<typename Number>
    void add_extension(const Eigen::VectorXd &values, LA::VectorOf<Number> &dst) const;

  private:
    std::vector<dealii::types::global_dof_index> dofs_;
  };
} // namespace stiction
