#include <stiction/elasticity/linear_algebra/amg_preconditioner.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/rigid_body_modes.h>
#include <stiction/elasticity/solvers/amg_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace stiction
{
  AmgSolver::AmgSolver(const LinearElasticity &elasticity, const double relative_residual)
    : StiffnessSolver(elasticity)
    , relative_residual_(relative_residual)
  {
    auto modes = rigid_body_modes(elasticity.body(), elasticity.mesh().node_positions());
    std::size_t k = 0;
    for (const auto dof : elasticity.body().locally_owned_dofs())
      {
        // a fixed unknown takes part in no motion
        if (elasticity.is_fixed(dof) || elasticity.is_hanging(dof))
          for (std::vector<double> &mode : modes)
            mode[k] = 0.;
        ++k;
      }
    amg_ = std::make_unique<AmgPreconditioner>(elasticity.constrained_stiffness(), modes);
  }

  AmgSolver::~AmgSolver() = default;

  unsigned int AmgSolver::do_solve(LA::Vector &dst, const LA::Vector &src)
  {
    dealii::SolverControl control(1000, relative_residual_ * src.l2_norm());
    dealii::SolverCG<LA::Vector> cg(control);
    dst = 0.;
    try
      {
        cg.solve(elasticity_.constrained_stiffness(), dst, src, *amg_);
      }
    catch (const dealii::SolverControl::NoConvergence &failure)
      {
        throw std::runtime_error(
          "conjugate gradients with algebraic multigrid did not converge in " +
          std::to_string(failure.last_step) +
          " iterations, use 'Stiffness solver/Type = mumps'.");
      }
    return control.last_step();
  }
} // namespace stiction
