#pragma once

#include <stiction/qp/methods/dual_method.h>
#include <stiction/qp/operators/dual_operator.h>

namespace stiction
{
  /// Given friction as one quadratic program over half-lines times discs,
  /// without splitting (MPGP: modified proportioning with gradient
  /// projections, Dostál, Kučera and Kozubek), with spectral release steps and Γ = 6,
  /// in variables with one scale a node, 1/√(nodal compliance), so that discs stay
  /// discs. Its energy falls in every step and it converges from anywhere: what faster
  /// methods fall back on.
  ///
  /// An iteration, for the cap and the history, is a stretch of
  /// products_in_an_iteration products with Q.
  class Mpgp : public DualMethod
  {
  public:
    static constexpr unsigned int products_in_an_iteration = 20;

    /// Estimates the norm of Q. The operator must outlive the method.
    explicit Mpgp(const DualOperator &Q);

    DualMethodResult solve(DualIterate &iterate, const Task &task) override;

    bool solves_coulomb() const override { return false; }

  private:
    const DualOperator &Q_;
    const Eigen::VectorXd D_;   ///< the diagonal of D, length 3m
    qp::SymmetricOperator DQD_; ///< of the variables y with λ = D y
    double norm_;
  };
} // namespace stiction
