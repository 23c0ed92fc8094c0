#pragma once

#include <stiction/qp/operators/equality_constraint.h>
#include <stiction/qp/operators/dual_operator.h>

#include <Eigen/Core>

#include <memory>

namespace stiction
{
  /// The dual operator of a body that nothing but contact holds, without what its rigid
  /// motions add: Π Q Π with Π = I − ĜĜᵀ, Ĝ an orthonormal basis of the range of G.
  ///
  /// Where Gᵀλ = e, the gradient Qλ − h + Gα is that of this operator, with the
  /// right-hand side h − Qλ₀, plus Ĝ times other multipliers: λ₀ are the shortest forces
  /// with Gᵀλ₀ = e. Which unknowns anchored the body does not enter Π Q Π.
  class DeflatedOperator : public DualOperator
  {
  public:
    /// @param Q with its right-hand side; must outlive the object. @param constraint
    ///   columns of G may depend on each other if the entries of e do so alike.
    DeflatedOperator(const DualOperator &Q, const EqualityConstraint &constraint);

    /// The same constraint with Ĝ.
    const EqualityConstraint &constraint() const { return constraint_; }

    /// The shortest forces that λ lacks to satisfy the constraint, N.
    Eigen::VectorXd lacking(const Eigen::VectorXd &lambda) const
    {
      return constraint_.G * (constraint_.e - constraint_.G.transpose() * lambda);
    }

    /// The multipliers α of G that go with those of Ĝ at contact forces λ.
    Eigen::VectorXd multipliers(const Eigen::VectorXd &of_basis,
                                const Eigen::VectorXd &lambda) const;

    /// Those of Ĝ that go with α.
    Eigen::VectorXd multipliers_of_basis(const Eigen::VectorXd &alpha,
                                         const Eigen::VectorXd &lambda) const;

    const Eigen::MatrixXd *matrix() const override;

  protected:
    Eigen::VectorXd compute_nodal_compliance() const override;

    void apply(DualBlock rows, DualBlock columns, Eigen::VectorXd &dst,
               const Eigen::VectorXd &src) const override;

  private:
    /// Ĝᵀ Q Π λ, m.
    Eigen::VectorXd shift(const Eigen::VectorXd &lambda) const;

    const DualOperator &Q_;
    EqualityConstraint constraint_;
    Eigen::MatrixXd to_basis_;                 ///< T with G = Ĝ T
    Eigen::MatrixXd Q_basis_;                  ///< Q Ĝ
    std::unique_ptr<DenseDualOperator> dense_; ///< if Q is known as a matrix
  };
} // namespace stiction
