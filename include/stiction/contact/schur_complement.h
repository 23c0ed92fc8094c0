#ifndef stiction_contact_schur_complement_h
#define stiction_contact_schur_complement_h

#include <stiction/elasticity/linear_algebra.h>
#include <stiction/qp/symmetric_operator.h>

#include <Eigen/Core>

#include <memory>
#include <string>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  class StiffnessSolver;

  /// A block of rows or columns of the dual operator.
  enum class DualBlock
  {
    normal,     ///< the m rows ν
    tangential, ///< the 2m rows t1, t2
    all         ///< all 3m rows
  };



  /// The contact dual operator Q = B K⁻¹ Bᵀ (m/N) and the dual right-hand side
  /// h = B K⁻¹ f − (d; 0; 0) (m) of the paper's problem (D).
  ///
  /// The condensation of the body to its contact nodes: λ ↦ Qλ is how far the
  /// contact nodes move under contact forces λ. Vectors are stored by blocks
  /// (ν; t1; t2) and known to all ranks.
  class SchurComplement
  {
  public:
    virtual ~SchurComplement() = default;

    /// The form chosen in the parameter file: "assembled" (a dense matrix) or
    /// "by solves" (one solve with K a product). Collective.
    static std::unique_ptr<SchurComplement>
    create(const std::string &form,
           const LinearElasticity &elasticity,
           const ContactSurface &surface,
           StiffnessSolver &solver);

    /// m.
    Eigen::Index
    n_nodes() const
    {
      return n_nodes_;
    }

    /// The dual right-hand side, length 3m.
    const Eigen::VectorXd &
    right_hand_side() const
    {
      return h_;
    }

    /// dst = Q_{rows,columns} src. Collective; counted.
    void
    vmult(DualBlock rows,
          DualBlock columns,
          Eigen::VectorXd &dst,
          const Eigen::VectorXd &src) const;

    /// Products so far in units of one with all of Q: a product with Q_νν
    /// counts 1/9, with Q_tt 4/9, with Q_νt or Q_tν 2/9.
    double
    n_multiplications() const
    {
      return n_ninths_ / 9.;
    }

  protected:
    SchurComplement(const LinearElasticity &elasticity,
                    const ContactSurface &surface);

    /// Computes h by one solve. Collective.
    void
    set_right_hand_side(StiffnessSolver &solver);

    virtual void
    apply(DualBlock rows,
          DualBlock columns,
          Eigen::VectorXd &dst,
          const Eigen::VectorXd &src) const = 0;

    /// The first entry and the length of a block.
    Eigen::Index
    begin(DualBlock block) const;
    Eigen::Index
    length(DualBlock block) const;

    const LinearElasticity &elasticity_;
    const ContactSurface &surface_;

  private:
    Eigen::Index n_nodes_;
    Eigen::VectorXd h_;
    mutable unsigned long n_ninths_ = 0;
  };



  /// A diagonal block of the dual operator, as the quadratic programs see it.
  class SchurBlock : public qp::SymmetricOperator
  {
  public:
    /// The Schur complement must outlive the block.
    SchurBlock(const SchurComplement &schur, DualBlock block);

    Eigen::Index
    size() const override;

  protected:
    void
    apply(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const override;

  private:
    const SchurComplement &schur_;
    const DualBlock block_;
  };
} // namespace stiction

#endif
