#include <stiction/elasticity/amg_solver.h>
#include <stiction/elasticity/body.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/rigid_body_modes.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>

#include <stdexcept>
#include <string>

namespace stiction
{
  // deal.II 9.4's interface to ML knows constant modes only; the coarse spaces
  // of elasticity need the rotations too, so ML gets its list by hand. It
  // keeps a pointer to the modes.
  struct AmgSolver::Hierarchy
  {
    std::unique_ptr<Epetra_MultiVector> modes;
    dealii::TrilinosWrappers::PreconditionAMG amg;
  };



  AmgSolver::AmgSolver(const LinearElasticity &elasticity,
                       const double relative_residual)
    : StiffnessSolver(elasticity)
    , hierarchy_(std::make_unique<Hierarchy>())
    , relative_residual_(relative_residual)
  {
    const LA::SparseMatrix &K = elasticity.constrained_stiffness();
    const auto modes          = rigid_body_modes(elasticity.body());
    const auto &owned         = elasticity.body().locally_owned_dofs();

    hierarchy_->modes = std::make_unique<Epetra_MultiVector>(
      K.trilinos_matrix().OperatorDomainMap(), static_cast<int>(modes.size()));
    for (unsigned int m = 0; m < modes.size(); ++m)
      {
        unsigned int k = 0;
        for (const auto dof : owned)
          {
            // a fixed unknown takes part in no motion
            (*(*hierarchy_->modes)(m))[k] =
              elasticity.constraints().is_constrained(dof) ? 0. : modes[m][k];
            ++k;
          }
      }

    Teuchos::ParameterList list;
    list.set("ML output", 0);
    list.set("max levels", 10);
    list.set("increasing or decreasing", "increasing");
    list.set("cycle applications", 1);
    list.set("prec type", "MGV");
    list.set("PDE equations", 3);
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", static_cast<int>(modes.size()));
    list.set("null space: vectors", hierarchy_->modes->Values());
    list.set("null space: add default vectors", false);
    list.set("aggregation: type", "Uncoupled");
    list.set("aggregation: threshold", 1e-2);
    list.set("smoother: type", "Chebyshev");
    list.set("smoother: sweeps", 2);
    list.set("smoother: pre or post", "both");
    list.set("smoother: Chebyshev alpha", 10.);
    list.set("coarse: type", "Amesos-KLU");
    list.set("coarse: max size", 300);
    list.set("initialize random seed", true);
    hierarchy_->amg.initialize(K, list);
  }



  AmgSolver::~AmgSolver() = default;



  unsigned int
  AmgSolver::do_solve(LA::Vector &dst, const LA::Vector &src)
  {
    dealii::SolverControl control(1000, relative_residual_ * src.l2_norm());
    dealii::SolverCG<LA::Vector> cg(control);
    dst = 0.;
    try
      {
        cg.solve(
          elasticity_.constrained_stiffness(), dst, src, hierarchy_->amg);
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
