#include <stiction/elasticity/body.h>
#include <stiction/elasticity/dense_cholesky.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/mumps_factorization.h>
#include <stiction/elasticity/mumps_solver.h>
#include <stiction/elasticity/trace.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <vector>

namespace stiction
{
  namespace
  {
    // unknowns are numbered node by node, three a node
    constexpr unsigned int dofs_per_node = 3;

    // A large matrix goes out in pieces: an MPI count is an int.
    void
    broadcast(Eigen::MatrixXd &matrix, MPI_Comm communicator)
    {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j)
        MPI_Bcast(matrix.col(j).data(),
                  static_cast<int>(matrix.rows()),
                  MPI_DOUBLE,
                  0,
                  communicator);
    }

    // Passage between a distributed vector, of which every rank owns a range,
    // and the whole on rank 0.
    class HostVector
    {
    public:
      explicit HostVector(const LA::Vector &v)
        : communicator_(v.get_mpi_communicator())
        , is_host_(dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
        , local_size_(static_cast<int>(v.locally_owned_size()))
        , counts_(dealii::Utilities::MPI::gather(communicator_, local_size_, 0))
        , offsets_(counts_.size(), 0)
      {
        for (std::size_t r = 1; r < counts_.size(); ++r)
          offsets_[r] = offsets_[r - 1] + counts_[r - 1];
      }

      Eigen::VectorXd
      gather(const LA::Vector &v) const
      {
        Eigen::VectorXd whole(is_host_ ? v.size() : 0);
        MPI_Gatherv(v.begin(),
                    local_size_,
                    MPI_DOUBLE,
                    whole.data(),
                    counts_.data(),
                    offsets_.data(),
                    MPI_DOUBLE,
                    0,
                    communicator_);
        return whole;
      }

      void
      scatter(const Eigen::VectorXd &whole, LA::Vector &v) const
      {
        MPI_Scatterv(whole.data(),
                     counts_.data(),
                     offsets_.data(),
                     MPI_DOUBLE,
                     v.begin(),
                     local_size_,
                     MPI_DOUBLE,
                     0,
                     communicator_);
      }

    private:
      MPI_Comm communicator_;
      bool is_host_;
      int local_size_;
      std::vector<int> counts_, offsets_;
    };

    // Whether an unknown is neither prescribed nor in the trace. Collective.
    bool
    has_interior(const LinearElasticity &elasticity, const Trace &trace)
    {
      dealii::IndexSet interior = elasticity.body().locally_owned_dofs();
      dealii::IndexSet taken(interior.size());
      taken.add_indices(trace.dofs().begin(), trace.dofs().end());
      for (const auto dof : interior)
        if (elasticity.constraints().is_constrained(dof))
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



  Eigen::MatrixXd
  MumpsSolver::compliance(const Trace &trace)
  {
    // With nothing but prescribed unknowns to eliminate MUMPS aborts on several
    // ranks; such a body is one cell thick.
    if (!has_interior(elasticity_, trace))
      return StiffnessSolver::compliance(trace);

    factorization_.reset(); // before the new one: it may be large
    factorization_ = std::make_unique<MumpsFactorization>(
      elasticity_.constrained_stiffness(), dofs_per_node, trace.dofs());
    is_condensed_ = true;

    const auto n = static_cast<int>(trace.size());
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



  unsigned int
  MumpsSolver::do_solve(LA::Vector &dst, const LA::Vector &src)
  {
    if (!factorization_)
      factorization_ = std::make_unique<MumpsFactorization>(
        elasticity_.constrained_stiffness(), dofs_per_node);

    const HostVector host(src);
    Eigen::VectorXd x = host.gather(src);
    if (is_condensed_)
      {
        Eigen::VectorXd condensed;
        factorization_->condense(x, condensed);
        if (factorization_->is_host())
          dense_cholesky::solve(factorization_->schur_complement().data(),
                                static_cast<int>(condensed.size()),
                                condensed.data());
        factorization_->expand(x, condensed);
      }
    else
      factorization_->solve(x);
    host.scatter(x, dst);
    return 0;
  }
} // namespace stiction
