#include <stiction/elasticity/linear_algebra/amg_preconditioner.h>

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace stiction
{
  // deal.II 9.4's interface to ML knows constant modes only; the coarse spaces
  // of elasticity need the rotations too, so ML gets its list by hand. It
  // keeps a pointer to the modes.
  struct AmgPreconditioner::Hierarchy
  {
    std::unique_ptr<Epetra_MultiVector> modes;
    dealii::TrilinosWrappers::PreconditionAMG amg;
  };

  AmgPreconditioner::AmgPreconditioner(const LA::SparseMatrix &matrix,
                                       const std::vector<std::vector<double>> &modes)
    : hierarchy_(std::make_unique<Hierarchy>())
  {
    hierarchy_->modes = std::make_unique<Epetra_MultiVector>(
      matrix.trilinos_matrix().OperatorDomainMap(), static_cast<int>(modes.size()));
    for (unsigned int m = 0; m < modes.size(); ++m)
      std::copy(modes[m].begin(), modes[m].end(),
                (*hierarchy_->modes)(static_cast<int>(m))->Values());

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
    hierarchy_->amg.initialize(matrix, list);
  }

  AmgPreconditioner::~AmgPreconditioner() = default;

  void AmgPreconditioner::vmult(LA::Vector &dst, const LA::Vector &src) const
  {
    hierarchy_->amg.vmult(dst, src);
  }
} // namespace stiction
