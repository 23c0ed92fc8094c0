#pragma once

#include <stiction/contact/interface/contact_frame.h>
#include <stiction/elasticity/linear_algebra/dof_subset.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace stiction
{
  /// B: from displacements of the body to displacements (n·u; s1 t1·u; s2 t2·u)
  /// of its contact nodes in their frames, and Bᵀ from contact forces to loads. Where
  /// another body is opposite, u is relative to Âu of its nodes, and the forces act on
  /// both. Where a node bears forces of others beside it, u is the mean of theirs, of
  /// which ContactFrame::own_part is its own and −Â has the others.
  ///
  /// Vectors over the contact nodes have length 3m, by blocks (ν; t1; t2) or
  /// (x; y; z), and every rank holds them in full.
  class ContactOperator
  {
  public:
    ContactOperator() = default;

    /// The nodes of other bodies, or of other boundaries, that lie opposite, and those
    /// that others bear forces for.
    struct OtherSide
    {
      DofSubset dofs;          ///< by blocks
      Eigen::VectorXd is_free; ///< 0 for each of them that is prescribed, otherwise 1
      /// W of the mortar, m × their number: how areas and tractions are shared.
      Eigen::SparseMatrix<double, Eigen::RowMajor> weights;
      Eigen::SparseMatrix<double, Eigen::RowMajor> A; ///< Â, by blocks
    };

    /// @param dofs the displacement unknowns of the nodes, by blocks.
    ContactOperator(DofSubset dofs, std::vector<ContactFrame> frames,
                    OtherSide other = {});

    Eigen::Index n_nodes() const { return dofs_.size() / 3; }

    /// Whether it is the same map, bit by bit.
    bool operator==(const ContactOperator &other) const;

    /// Whether it is that map but for the frames of nodes, which are held in the same
    /// directions: what lies opposite, and in which basis, is the same.
    bool is_turned(const ContactOperator &other) const;

    /// Those of the contact nodes.
    const DofSubset &dofs() const { return dofs_; }

    /// Those of the contact nodes and behind them those opposite.
    DofSubset all_dofs() const;

    const OtherSide &other_side() const { return other_; }

    bool has_other_side() const { return other_.dofs.size() > 0; }

    const std::vector<ContactFrame> &frames() const { return frames_; }

    /// B u. Collective.
    Eigen::VectorXd apply(const LA::Vector &u) const;

    /// B u of rigid motions of bodies, 0 where both sides move alike but for rounding.
    /// Collective.
    Eigen::VectorXd apply_to_motion(const LA::Vector &u) const;

    /// dst += factor Bᵀ λ, what supports bear included. Collective.
    void add_transpose(double factor, const Eigen::VectorXd &lambda,
                       LA::Vector &dst) const;

    /// The same where unknowns are free. Collective.
    void add_load(double factor, const Eigen::VectorXd &lambda, LA::Vector &dst) const;

    /// u of the contact nodes relative to what lies opposite, by blocks (x; y; z).
    /// Collective.
    Eigen::VectorXd relative_displacement(const LA::Vector &u) const;

    /// Sets the entries of the contact nodes to those of Bᵀ λ, where they are
    /// prescribed to 0. Collective.
    void set_transpose(const Eigen::VectorXd &lambda, LA::Vector &dst) const;

    /// u += factor × the displacement of the contact nodes with B u = w, in the
    /// directions that are not held. Collective.
    void add_displacement(double factor, const Eigen::VectorXd &w, LA::Vector &u) const;

    /// The λ for which Bᵀ λ is R at the contact nodes, in free directions. Collective.
    Eigen::VectorXd contact_forces(const LA::Vector &R) const;

    /// The forces Bᵀ λ at the contact nodes, by blocks (x; y; z), and back.
    Eigen::VectorXd force_to_cartesian(const Eigen::VectorXd &lambda) const;
    Eigen::VectorXd force_to_local(const Eigen::VectorXd &force) const;

    /// B C Bᵀ with the compliance C of all_dofs(): displacements (x; y; z) under forces
    /// (x; y; z). In place where nothing lies opposite: C may be large.
    Eigen::MatrixXd compliance(Eigen::MatrixXd C) const;

    /// 1 for each contact variable in whose direction the node is held, 0 for
    /// the others.
    Eigen::VectorXd held() const;

  private:
    /// Whether nodes and what lies opposite are the same.
    bool has_nodes_of(const ContactOperator &other) const;

    /// Bᵀ λ at the contact nodes where unknowns are free.
    Eigen::VectorXd free_forces(const Eigen::VectorXd &lambda) const;

    /// Forces on what lies opposite, by blocks (x; y; z).
    Eigen::VectorXd forces_on_other_side(const Eigen::VectorXd &lambda) const;

    /// M C Mᵀ with the nodal matrices M of B, in one pass.
    void rotate_to_local(Eigen::MatrixXd &C) const;

    DofSubset dofs_;
    std::vector<ContactFrame> frames_;
    OtherSide other_;
  };
} // namespace stiction
