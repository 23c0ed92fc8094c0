#pragma once

#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/slip_bound.h>

#include <Eigen/Core>

namespace stiction
{
  /// A block of rows or columns of the dual operator.
  enum class DualBlock
  {
    normal,     ///< the m rows ν
    tangential, ///< the 2m rows t1, t2
    all         ///< all 3m rows
  };

  /// The dual Hessian Q (m/N) and the dual right-hand side h (m) of the
  /// paper's problem (D), wherever they come from.
  ///
  /// λ ↦ Qλ is how far the contact nodes move under contact forces λ. Vectors
  /// are stored by blocks (ν; t1; t2) and known to all ranks.
  class DualOperator
  {
  public:
    virtual ~DualOperator() = default;

    /// m.
    Eigen::Index n_nodes() const { return n_nodes_; }

    /// h, length 3m.
    const Eigen::VectorXd &right_hand_side() const { return h_; }

    /// dst = Q_{rows,columns} src. Collective; counted.
    void vmult(DualBlock rows, DualBlock columns, Eigen::VectorXd &dst,
               const Eigen::VectorXd &src) const;

    /// Q_{block,block} as the quadratic programs see it. The operator must outlive it.
    qp::SymmetricOperator diagonal_block(DualBlock block) const;

    /// Products so far in units of one with all of Q: a product with Q_νν
    /// counts 1/9, with Q_tt 4/9, with Q_νt or Q_tν 2/9.
    double n_multiplications() const { return static_cast<double>(n_ninths_) / 9.; }

    /// tr(Q_ii)/3 at every node, or an estimate of it: how much a node gives
    /// way to its own force. Length m, > 0. Computed when first asked for;
    /// collective.
    const Eigen::VectorXd &nodal_compliance() const;

    /// Q itself, or nullptr if it is known by its action only.
    virtual const Eigen::MatrixXd *matrix() const { return nullptr; }

    /// Other loads, or obstacles at other places. @param h length 3m.
    void set_right_hand_side(Eigen::VectorXd h);

  protected:
    explicit DualOperator(Eigen::Index n_nodes);

    /// Computes what nodal_compliance() returns. Collective.
    virtual Eigen::VectorXd compute_nodal_compliance() const = 0;

    /// An estimate of it from its shape, by one product. @param shape length m, > 0.
    Eigen::VectorXd estimated_compliance(const Eigen::VectorXd &shape) const;

    virtual void apply(DualBlock rows, DualBlock columns, Eigen::VectorXd &dst,
                       const Eigen::VectorXd &src) const = 0;

    /// The first entry and the length of a block.
    Eigen::Index begin(DualBlock block) const;
    Eigen::Index length(DualBlock block) const;

  private:
    Eigen::Index n_nodes_;
    Eigen::VectorXd h_;
    mutable Eigen::VectorXd nodal_compliance_;
    mutable unsigned long n_ninths_ = 0;
  };

  /// Q as a dense symmetric matrix.
  class DenseDualOperator : public DualOperator
  {
  public:
    /// @param Q symmetric positive definite, 3m × 3m; @param h length 3m.
    DenseDualOperator(Eigen::MatrixXd Q, Eigen::VectorXd h);

    const Eigen::MatrixXd *matrix() const override { return &Q_; }

  protected:
    Eigen::VectorXd compute_nodal_compliance() const override;

    void apply(DualBlock rows, DualBlock columns, Eigen::VectorXd &dst,
               const Eigen::VectorXd &src) const override;

  private:
    Eigen::MatrixXd Q_;
  };

  /// What it would take to undo h node by node, its overlaps (not its open
  /// gaps) and as much of its slips as friction bears, with c the nodal compliance: a
  /// scale of forces and of work that does not depend on any solution.
  struct DecoupledScales
  {
    double force = 0.; ///< Σ‖f_i‖ of f_i = (h_ν⁺, h_t)_i/c_i in its convex set, N
    double work  = 0.; ///< Σ‖f_i‖² c_i, Nm
  };

  /// Collective.
  DecoupledScales decoupled_scales(const DualOperator &Q,
                                   const qp::SlipBound &slip_bound);
} // namespace stiction
