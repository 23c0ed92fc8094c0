#include <stiction/elasticity/linear_algebra/dense_cholesky.h>
#include <stiction/elasticity/linear_algebra/dof_subset.h>
#include <stiction/elasticity/linear_algebra/host_vector.h>
#include <stiction/elasticity/linear_algebra/mumps_factorization.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/solvers/mumps_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace stiction
{
  namespace
  {
    // A large matrix goes out in pieces: an MPI count is an int.
    void broadcast(Eigen::MatrixXd &matrix, MPI_Comm communicator)
    {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j)
        MPI_Bcast(matrix.col(j).data(), static_cast<int>(matrix.rows()), MPI_DOUBLE, 0,
                  communicator);
    }

    // Whether an unknown is neither prescribed nor in the subset. Collective.
    bool has_interior(const LinearElasticity &elasticity, const DofSubset &subset)
    {
      dealii::IndexSet interior = elasticity.body().locally_owned_dofs();
      dealii::IndexSet taken(interior.size());
      taken.add_indices(subset.dofs().begin(), subset.dofs().end());
      for (const auto dof : interior)
        if (elasticity.is_fixed(dof) || elasticity.is_hanging(dof))
          taken.add_index(dof);
      interior.subtract_set(taken);
      return dealii::Utilities::MPI::sum(
               static_cast<unsigned int>(interior.is_empty() ? 0 : 1),
               elasticity.body().communicator()) > 0;
    }
  } // namespace

  MumpsSolver::MumpsSolver(const LinearElasticity &elasticity)
    : StiffnessSolver(elasticity)
  {
  }

  MumpsSolver::~MumpsSolver() = default;

  Eigen::MatrixXd MumpsSolver::compliance(const DofSubset &subset)
  {
    // With nothing but prescribed unknowns to eliminate MUMPS aborts on several
    // ranks; such a body is one cell thick.
    if (!has_interior(elasticity_, subset))
      return StiffnessSolver::compliance(subset);

    factorization_.reset(); // before the new one: it may be large
    factorization_ = std::make_unique<MumpsFactorization>(
      elasticity_.constrained_stiffness(), subset.dofs());
    is_condensed_ = true;

    const auto n = static_cast<int>(subset.size());
    Eigen::MatrixXd C(n, n);
    if (factorization_->is_host())
      {
        // in place: MUMPS has no more use for S, the solves need its factor
        Eigen::MatrixXd &S = factorization_->schur_complement();
        dense_cholesky::factorize(S.data(), n);
        C = S;
        dense_cholesky::invert(C.data(), n);
        C.triangularView<Eigen::StrictlyUpper>() = C.transpose();
      }
    broadcast(C, elasticity_.body().communicator());
    return C;
  }

  unsigned int MumpsSolver::do_solve(LA::Vector &dst, const LA::Vector &src)
  {
    if (!factorization_)
      factorization_ =
        std::make_unique<MumpsFactorization>(elasticity_.constrained_stiffness());

    const HostVector host(src);
    Eigen::VectorXd x = host.gather(src);
    if (is_condensed_)
      {
        Eigen::VectorXd condensed;
        factorization_->condense(x, condensed);
        if (factorization_->is_host())
          dense_cholesky::solve(factorization_->schur_complement().data(),
                                static_cast<int>(condensed.size()), condensed.data());
        factorization_->expand(x, condensed);
      }
    else
      factorization_->solve(x);
    host.scatter(x, dst);
    return 0;
  }
} // namespace stiction
