#pragma once

#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/nodal_constraint.h>

#include <memory>

namespace stiction
{
  class Multigrid;

  /// K⁻¹ by conjugate gradients without a matrix, preconditioned with multigrid, or
  /// flexible GMRES where that is not linear; with a factorisation where that does not
  /// converge and the mesh is small enough for one.
  class MultigridSolver : public StiffnessSolver
  {
  public:
    /// Sets up the levels. Collective.
    MultigridSolver(const LinearElasticity &elasticity, double relative_residual);

    /// With a preconditioner that exists already and outlives the object. Collective.
    ///
    /// @param level the number of its last level.
    /// @param supports of the nodes of its list, without contact.
    MultigridSolver(const LinearElasticity &elasticity, Multigrid &preconditioner,
                    unsigned int level, const NodalSupports &supports,
                    double relative_residual);
    ~MultigridSolver() override;

  protected:
    unsigned int do_solve(LA::Vector &dst, const LA::Vector &src) override;

  private:
    struct Levels;
    std::unique_ptr<Levels> levels_;
    Multigrid *preconditioner_;
    unsigned int level_;
    NodalSupports supports_;
    const double relative_residual_;
  };
} // namespace stiction
