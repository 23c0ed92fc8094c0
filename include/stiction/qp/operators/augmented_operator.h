#pragma once

#include <stiction/qp/operators/equality_constraint.h>
#include <stiction/qp/operators/dual_operator.h>

#include <Eigen/Core>

#include <memory>

namespace stiction
{
  /// The dual operator of the augmented Lagrangian of a problem with an equality
  /// constraint: with multipliers α and weights ρ (m/N)
  ///
  ///     Q + G ρ Gᵀ  and  h − G(α − ρ e).
  ///
  /// Its gradient at λ is Qλ − h + Gα⁺ with α⁺ = α + ρ(Gᵀλ − e): a solution of
  /// this problem solves the constrained one but for the constraint, with the
  /// multipliers α⁺, which are nearer to the right ones than α (method of
  /// multipliers). An obstacle on a spring of compliance ρ is the same problem.
  class AugmentedOperator : public DualOperator
  {
  public:
    /// @param Q with its right-hand side; must outlive the object.
    /// @param weights ρ, length n, > 0, m/N.
    AugmentedOperator(const DualOperator &Q, EqualityConstraint constraint,
                      Eigen::VectorXd multipliers, Eigen::VectorXd weights);

    /// α⁺ of contact forces. Unit: m.
    Eigen::VectorXd multipliers(const Eigen::VectorXd &lambda) const;

    /// α.
    const Eigen::VectorXd &multipliers() const { return multipliers_; }
    void set_multipliers(Eigen::VectorXd multipliers);

    const EqualityConstraint &constraint() const { return constraint_; }

    /// Multiplies ρ: another operator for whoever keeps something of it.
    void scale_weights(double factor) { set_weights(factor * weights_); }

    const Eigen::MatrixXd *matrix() const override;

  protected:
    /// That of Q: what a node gives way to its own force with the constraint held.
    Eigen::VectorXd compute_nodal_compliance() const override;

    void apply(DualBlock rows, DualBlock columns, Eigen::VectorXd &dst,
               const Eigen::VectorXd &src) const override;

  private:
    void set_weights(Eigen::VectorXd weights);

    const DualOperator &Q_;
    const EqualityConstraint constraint_;
    Eigen::VectorXd weights_, multipliers_;
    std::unique_ptr<DenseDualOperator> dense_; ///< if Q is known as a matrix
  };
} // namespace stiction
