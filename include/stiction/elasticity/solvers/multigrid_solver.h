#ifndef stiction_elasticity_solvers_multigrid_solver_h
#define stiction_elasticity_solvers_multigrid_solver_h

#include <stiction/elasticity/solvers/stiffness_solver.h>

#include <memory>

namespace stiction
{
  class StiffnessPreconditioner;

  /// K⁻¹ by conjugate gradients without a matrix, preconditioned with
  /// multigrid.
  class MultigridSolver : public StiffnessSolver
  {
  public:
    /// Sets up the levels. Collective.
    MultigridSolver(const LinearElasticity &elasticity, double relative_residual);

    /// With a preconditioner that exists already, without supports on the
    /// mesh, and outlives the object.
    ///
    /// @param level the number of its last level.
    MultigridSolver(const LinearElasticity &elasticity,
                    StiffnessPreconditioner &preconditioner, unsigned int level,
                    double relative_residual);
    ~MultigridSolver() override;

  protected:
    unsigned int do_solve(LA::Vector &dst, const LA::Vector &src) override;

  private:
    struct Levels;
    std::unique_ptr<Levels> levels_;
    StiffnessPreconditioner *preconditioner_;
    unsigned int level_;
    const double relative_residual_;
  };
} // namespace stiction

#endif
