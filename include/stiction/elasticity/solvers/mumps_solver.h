#pragma once

#include <stiction/elasticity/solvers/stiffness_solver.h>

namespace stiction
{
  class MumpsFactorization;

  /// K⁻¹ by a sparse Cholesky factorisation (MUMPS).
  ///
  /// Factorised when first needed. If that is for a compliance, the unknowns
  /// in question are eliminated last: then the compliance is the inverse of
  /// their Schur complement, without a single solve, and the same
  /// factorisation serves all solves afterwards.
  class MumpsSolver : public StiffnessSolver
  {
  public:
    explicit MumpsSolver(const LinearElasticity &elasticity);
    ~MumpsSolver() override;

    Eigen::MatrixXd compliance(const DofSubset &subset) override;

  protected:
    unsigned int do_solve(LA::Vector &dst, const LA::Vector &src) override;

  private:
    std::unique_ptr<MumpsFactorization> factorization_;
    /// Whether that is one with a Schur complement, in whose place then its
    /// Cholesky factor stands.
    bool is_condensed_ = false;
  };
} // namespace stiction
