#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/stiffness/nodal_constraint.h>

#include <deal.II/base/types.h>

#include <Eigen/Core>

#include <array>
#include <memory>
#include <unordered_map>
#include <vector>

namespace stiction
{
  /// An assembled stiffness matrix K with supports, P K P + S + (I − P) D
  /// (I − P): P projects onto what is free at the nodes, S are springs, and D,
  /// the diagonal of K, keeps held directions of the size of others.
  /// Unknowns without stiffness, those of hanging nodes, get a diagonal entry
  /// of that size too.
  class ConstrainedMatrix
  {
  public:
    /// @param stiffness must outlive the object.
    /// @param fixed not zero at unknowns with prescribed displacement.
    /// @param supported_nodes the first unknowns of the nodes that supports may
    ///   hold; the same on all ranks. Collective.
    ConstrainedMatrix(
      const LA::SparseMatrix &stiffness, const LA::Vector &fixed,
      const std::vector<dealii::types::global_dof_index> &supported_nodes);
    ~ConstrainedMatrix();

    /// Takes supports for the nodes of the list, the same on all ranks.
    void set_supports(const NodalSupports &supports);

    const LA::SparseMatrix &matrix() const { return *matrix_; }

    /// Hands the matrix over; the object is of no more use.
    std::unique_ptr<LA::SparseMatrix> release();

  private:
    /// A node with columns on this rank, and which of its unknowns are fixed.
    struct Node
    {
      dealii::types::global_dof_index first_dof;
      std::array<bool, 3> is_fixed;
    };

    void find_nodes(const LA::Vector &fixed);

    /// What is free at a node.
    Eigen::Matrix3d projection(const Node &node, const NodalSupports &supports) const;

    /// The block of a node with itself: with its support, and with what keeps
    /// held directions from being singular.
    Eigen::Matrix3d constrained_diagonal(const Eigen::Matrix3d &block, const Node &node,
                                         const Eigen::Matrix3d &P,
                                         const NodalSupports &supports) const;

    const LA::SparseMatrix &stiffness_;
    std::unique_ptr<LA::SparseMatrix> matrix_;
    std::unordered_map<dealii::types::global_dof_index, std::size_t>
      support_of_; ///< place in the list by first unknown
    std::vector<Node> nodes_;
    /// Three times the place of the node in this list plus the direction, by
    /// local column: Trilinos keeps columns in an order of its own.
    std::vector<unsigned int> unknown_of_column_;
    double mean_diagonal_ = 0.; ///< N/m, of unknowns with stiffness
  };
} // namespace stiction
