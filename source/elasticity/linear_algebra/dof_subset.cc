#include <stiction/elasticity/linear_algebra/dof_subset.h>
#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <utility>

namespace stiction
{
  DofSubset::DofSubset(std::vector<dealii::types::global_dof_index> dofs)
    : dofs_(std::move(dofs))
  {
  }

  DofSubset DofSubset::of_nodes(
    const std::vector<dealii::types::global_dof_index> &first_dofs)
  {
    const std::size_t m = first_dofs.size();
    std::vector<dealii::types::global_dof_index> dofs(3 * m);
    for (std::size_t i = 0; i < m; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        dofs[i + c * m] = first_dofs[i] + c;
    return DofSubset(std::move(dofs));
  }

  Eigen::VectorXd DofSubset::restriction(const LA::Vector &u) const
  {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(size());
    for (Eigen::Index i = 0; i < size(); ++i)
      if (u.in_local_range(dofs_[i]))
        values(i) = u(dofs_[i]);
    sum_over_ranks(values, u.get_mpi_communicator());
    return values;
  }

  void DofSubset::add_extension(const Eigen::VectorXd &values, LA::Vector &dst) const
  {
    for (Eigen::Index i = 0; i < size(); ++i)
      if (dst.in_local_range(dofs_[i]))
        dst(dofs_[i]) += values(i);
    dst.compress(dealii::VectorOperation::add);
  }
} // namespace stiction
