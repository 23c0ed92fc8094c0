#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/levels/dof_subset_hierarchy.h>
#include <stiction/elasticity/levels/mesh_hierarchy.h>
#include <stiction/elasticity/multigrid/multigrid.h>
#include <stiction/elasticity/solvers/multigrid_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace stiction
{
  namespace
  {
    // A preconditioner that iterates gains a digit each time where it is of use.
    constexpr unsigned int max_iterations = 500, max_of_iterated = 50;

    // K with the rows and columns of the given unknowns left out.
    struct ConstrainedOperator
    {
      const StiffnessOperator<double> &K;
      const std::vector<unsigned int> &fixed;

      void vmult(LA::Vector &dst, const LA::Vector &src) const
      {
        K.vmult(dst, src); // src is zero there
        for (const unsigned int k : fixed)
          dst.local_element(k) = 0.;
      }
    };

    struct Preconditioner
    {
      Multigrid &multigrid;
      const unsigned int level;
      mutable LA::VectorOf<float> scratch;

      void vmult(LA::Vector &dst, const LA::Vector &src) const
      {
        const double factor = multigrid.vmult(level, scratch, src);
        for (unsigned int k = 0; k < dst.locally_owned_size(); ++k)
          dst.local_element(k) = factor * scratch.local_element(k);
      }
    };
  } // namespace

  struct MultigridSolver::Levels
  {
    explicit Levels(const LinearElasticity &elasticity)
      : hierarchy(elasticity.body(), elasticity.mesh())
      , anchored(hierarchy, first_dofs(elasticity.anchors()))
      , multigrid(elasticity, hierarchy, anchored)
    {
    }

    // Of the nodes of unknowns, which stand together.
    static std::vector<dealii::types::global_dof_index> first_dofs(
      const std::vector<dealii::types::global_dof_index> &dofs)
    {
      std::set<dealii::types::global_dof_index> nodes;
      for (const auto dof : dofs)
        nodes.insert(dof - dof % 3);
      return {nodes.begin(), nodes.end()};
    }

    MeshHierarchy hierarchy;
    DofSubsetHierarchy anchored;
    Multigrid multigrid;
  };

  MultigridSolver::MultigridSolver(const LinearElasticity &elasticity,
                                   const double relative_residual)
    : StiffnessSolver(elasticity)
    , levels_(std::make_unique<Levels>(elasticity))
    , preconditioner_(&levels_->multigrid)
    , level_(levels_->hierarchy.n_levels() - 1)
    , relative_residual_(relative_residual)
  {
    const auto &nodes = levels_->anchored.first_dofs(level_);
    supports_.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (const auto dof : elasticity.anchors())
        if (dof - dof % 3 == nodes[i])
          supports_[i].projection(dof % 3, dof % 3) = 0.;
    preconditioner_->set_supports(level_, supports_);
  }

  MultigridSolver::MultigridSolver(const LinearElasticity &elasticity,
                                   Multigrid &preconditioner, const unsigned int level,
                                   const NodalSupports &supports,
                                   const double relative_residual)
    : StiffnessSolver(elasticity)
    , preconditioner_(&preconditioner)
    , level_(level)
    , supports_(supports)
    , relative_residual_(relative_residual)
  {
    preconditioner_->set_supports(level, supports);
  }

  MultigridSolver::~MultigridSolver() = default;

  unsigned int MultigridSolver::do_solve(LA::Vector &dst, const LA::Vector &src)
  {
    // prescribed unknowns stand in src multiplied with the diagonal entry
    std::vector<unsigned int> fixed;
    LA::Vector prescribed = elasticity_.zero_vector();
    bool is_moved         = false;
    for (const auto dof : src.locally_owned_elements())
      if (levels_ ? elasticity_.is_fixed(dof) : elasticity_.is_prescribed(dof))
        {
          fixed.push_back(src.get_partitioner()->global_to_local(dof));
          is_moved = is_moved || src(dof) != 0.;
        }
    LA::Vector b = src;
    for (const unsigned int k : fixed)
      b.local_element(k) = 0.;
    is_moved = dealii::Utilities::MPI::logical_or(is_moved, src.get_mpi_communicator());
    if (is_moved)
      {
        const LA::Vector diagonal = elasticity_.stiffness_diagonal();
        for (const unsigned int k : fixed)
          prescribed.local_element(k) = src.local_element(k) / diagonal.local_element(k);
      }

    dealii::SolverControl control(0, relative_residual_ * b.l2_norm());
    const auto iterate = [&]() {
      const bool is_linear = preconditioner_->is_linear(level_);
      control.set_max_steps(is_linear ? max_iterations : max_of_iterated);
      const ConstrainedOperator K{elasticity_.stiffness(), fixed};
      const Preconditioner cycle{*preconditioner_, level_,
                                 elasticity_.mesh().zero_vector<float>()};
      dst = 0.;
      try
        {
          if (is_linear)
            dealii::SolverCG<LA::Vector>(control).solve(K, dst, b, cycle);
          else
            dealii::SolverFGMRES<LA::Vector>(control).solve(K, dst, b, cycle);
          return true;
        }
      catch (const dealii::SolverControl::NoConvergence &)
        {
          return false;
        }
    };
    bool is_solved = iterate();
    if (!is_solved && preconditioner_->factorize(level_))
      {
        preconditioner_->set_supports(level_, supports_);
        is_solved = iterate();
      }
    if (!is_solved)
      throw std::runtime_error("iterations with multigrid did not converge in " +
                               std::to_string(control.max_steps()) +
                               " iterations, use 'Stiffness solver/Type = mumps'.");
    dst += prescribed;
    return control.last_step();
  }
} // namespace stiction
