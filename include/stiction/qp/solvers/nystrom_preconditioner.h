#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace stiction::qp
{
  class ContactLinearization;

  /// A preconditioner for the linear systems of the Newton method, made of
  /// the products with Q that were computed before and cost nothing more.
  ///
  /// From directions U and their images QU follows Nyström's approximation
  /// Q̂ = QU (UᵀQU)⁻¹ (QU)ᵀ ≤ Q. Krylov directions meet the largest
  /// eigenvalues of Q first, the few bending-like modes of the body that every
  /// step would have to find again. The matrix of a step is approximated by
  /// diag(δ) + WᵀQ̂Z with δ the curvature and what Q̂ lacks of the diagonal of
  /// Q, and inverted by Woodbury's formula at the cost of a few vectors.
  class NystromPreconditioner
  {
  public:
    /// Remembers a direction d ≠ 0 of length 3m and Qd, while there is room.
    void add(const Eigen::VectorXd &d, const Eigen::VectorXd &Qd);

    /// Makes the preconditioner of a step.
    ///
    /// @param nodal_compliance about tr(Q_ii)/3, length m.
    void set_up(const ContactLinearization &step,
                const Eigen::VectorXd &nodal_compliance);

    /// P⁻¹ v, of the length of the step's free components.
    Eigen::VectorXd apply(const Eigen::VectorXd &v) const;

  private:
    void update_root();

    Eigen::MatrixXd directions_, images_;
    Eigen::MatrixXd root_; ///< C with Q̂ = CCᵀ
    bool is_current_ = true;

    Eigen::MatrixXd trial_root_, test_root_; ///< ZᵀC and WᵀC of the step
    Eigen::VectorXd diagonal_;               ///< δ
    Eigen::PartialPivLU<Eigen::MatrixXd> capacitance_;
  };
} // namespace stiction::qp
