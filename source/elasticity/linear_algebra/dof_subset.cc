#include <stiction/elasticity/linear_algebra/dof_subset.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <utility>

namespace stiction
{
  DofSubset::DofSubset(std::vector<dealii::types::global_dof_index> dofs)
    : dofs_(std::move(dofs))
  {
  }



  Eigen::VectorXd
  DofSubset::restriction(const LA::Vector &u) const
  {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(size());
    for (Eigen::Index i = 0; i < size(); ++i)
      if (u.in_local_range(dofs_[i]))
        values(i) = u(dofs_[i]);
    dealii::Utilities::MPI::sum(
      dealii::ArrayView<const double>(values.data(), values.size()),
      u.get_mpi_communicator(),
      dealii::ArrayView<double>(values.data(), values.size()));
    return values;
  }



  void
  DofSubset::add_extension(const Eigen::VectorXd &values, LA::Vector &dst) const
  {
    for (Eigen::Index i = 0; i < size(); ++i)
      if (dst.in_local_range(dofs_[i]))
        dst(dofs_[i]) += values(i);
    dst.compress(dealii::VectorOperation::add);
  }
} // namespace stiction
