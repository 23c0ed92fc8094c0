#ifndef stiction_contact_interface_contact_operator_h
#define stiction_contact_interface_contact_operator_h

#include <stiction/contact/interface/contact_frame.h>
#include <stiction/elasticity/linear_algebra/dof_subset.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <Eigen/Core>

#include <vector>

namespace stiction
{
  /// B: from displacements of the body to displacements (n·u; s1 t1·u; s2 t2·u)
  /// of its contact nodes in their frames, and Bᵀ from contact forces to loads.
  ///
  /// Vectors over the contact nodes have length 3m, by blocks (ν; t1; t2) or
  /// (x; y; z), and every rank holds them in full.
  class ContactOperator
  {
  public:
    ContactOperator() = default;

    /// @param dofs the displacement unknowns of the nodes, by blocks.
    ContactOperator(DofSubset dofs, std::vector<ContactFrame> frames);

    Eigen::Index n_nodes() const { return dofs_.size() / 3; }

    /// Whether it is the same map, bit by bit.
    bool operator==(const ContactOperator &other) const;

    const DofSubset &dofs() const { return dofs_; }

    const std::vector<ContactFrame> &frames() const { return frames_; }

    /// B u. Collective.
    Eigen::VectorXd apply(const LA::Vector &u) const;

    /// dst += factor Bᵀ λ. Collective.
    void add_transpose(double factor, const Eigen::VectorXd &lambda,
                       LA::Vector &dst) const;

    /// Sets the entries of the contact nodes to those of Bᵀ λ, in held
    /// directions to 0. Collective.
    void set_transpose(const Eigen::VectorXd &lambda, LA::Vector &dst) const;

    /// u += factor × the displacement of the contact nodes with B u = w, in the
    /// directions that are not held. Collective.
    void add_displacement(double factor, const Eigen::VectorXd &w, LA::Vector &u) const;

    /// The λ for which Bᵀ λ is R at the contact nodes, in directions that are
    /// not held. Collective.
    Eigen::VectorXd contact_forces(const LA::Vector &R) const;

    /// The forces Bᵀ λ at the contact nodes, by blocks (x; y; z), and back.
    Eigen::VectorXd force_to_cartesian(const Eigen::VectorXd &lambda) const;
    Eigen::VectorXd force_to_local(const Eigen::VectorXd &force) const;

    /// Replaces a matrix of order 3m, of displacements (x; y; z) under forces
    /// (x; y; z), by M C Mᵀ with the nodal matrices M of B, in one pass: C may
    /// be large.
    void rotate_to_local(Eigen::MatrixXd &C) const;

    /// 1 for each contact variable in whose direction the node is held, 0 for
    /// the others.
    Eigen::VectorXd held() const;

  private:
    DofSubset dofs_;
    std::vector<ContactFrame> frames_;
  };
} // namespace stiction

#endif
