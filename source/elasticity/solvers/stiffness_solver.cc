#include <stiction/elasticity/linear_algebra/dof_subset.h>
#include <stiction/elasticity/solvers/amg_solver.h>
#include <stiction/elasticity/solvers/multigrid_solver.h>
#include <stiction/elasticity/solvers/mumps_solver.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

namespace stiction
{
  StiffnessSolver::StiffnessSolver(const LinearElasticity &elasticity)
    : elasticity_(elasticity)
  {
  }

  std::unique_ptr<StiffnessSolver> StiffnessSolver::create(
    const std::string &type, const LinearElasticity &elasticity,
    const double relative_residual)
  {
    if (type == "amg")
      return std::make_unique<AmgSolver>(elasticity, relative_residual);
    if (type == "multigrid")
      return std::make_unique<MultigridSolver>(elasticity, relative_residual);
    return std::make_unique<MumpsSolver>(elasticity);
  }

  void StiffnessSolver::solve(LA::Vector &dst, const LA::Vector &src)
  {
    if (elasticity_.anchors().empty())
      n_iterations_ += do_solve(dst, src);
    else
      {
        // of loads in balance what acts there is the same as what the others ask for
        LA::Vector without_anchors = src;
        for (const auto dof : elasticity_.anchors())
          if (src.in_local_range(dof))
            without_anchors(dof) = 0.;
        n_iterations_ += do_solve(dst, without_anchors);
      }
    ++n_solves_;
  }

  Eigen::MatrixXd StiffnessSolver::compliance(const DofSubset &subset)
  {
    Eigen::MatrixXd C(subset.size(), subset.size());
    LA::Vector unit_force   = elasticity_.zero_vector();
    LA::Vector displacement = elasticity_.zero_vector();
    for (Eigen::Index j = 0; j < subset.size(); ++j)
      {
        unit_force = 0.;
        subset.add_extension(Eigen::VectorXd::Unit(subset.size(), j), unit_force);
        displacement = 0.;
        solve(displacement, unit_force);
        C.col(j) = subset.restriction(displacement);
      }
    return 0.5 * (C + C.transpose());
  }
} // namespace stiction
