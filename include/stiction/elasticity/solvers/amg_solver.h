#pragma once

#include <stiction/elasticity/solvers/stiffness_solver.h>

namespace stiction
{
  class AmgPreconditioner;

  /// K⁻¹ by conjugate gradients, preconditioned with smoothed-aggregation
  /// algebraic multigrid (Trilinos ML) that is told the six rigid-body modes.
  class AmgSolver : public StiffnessSolver
  {
  public:
    /// Sets up the hierarchy. Collective.
    AmgSolver(const LinearElasticity &elasticity, double relative_residual);
    ~AmgSolver() override;

  protected:
    unsigned int do_solve(LA::Vector &dst, const LA::Vector &src) override;

  private:
    std::unique_ptr<AmgPreconditioner> amg_;
    const double relative_residual_;
  };
} // namespace stiction
