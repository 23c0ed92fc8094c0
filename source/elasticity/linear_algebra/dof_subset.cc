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

  DofSubset DofSubset::node_by_node(
    const std::vector<dealii::types::global_dof_index> &first_dofs)
  {
    std::vector<dealii::types::global_dof_index> dofs;
    for (const auto first : first_dofs)
      dofs.insert(dofs.end(), {first, first + 1, first + 2});
    return DofSubset(std::move(dofs));
  }

  template<typename Number>
  Eigen::VectorXd DofSubset::restriction(const LA::VectorOf<Number> &u) const
  {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(size());
    for (Eigen::Index i = 0; i < size(); ++i)
      if (u.in_local_range(dofs_[i]))
        values(i) = u(dofs_[i]);
    sum_over_ranks(values, u.get_mpi_communicator());
    return values;
  }

  template<typename Number>
  void DofSubset::add_extension(const Eigen::VectorXd &values,
                                LA::VectorOf<Number> &dst) const
  {
    for (Eigen::Index i = 0; i < size(); ++i)
      if (dst.in_local_range(dofs_[i]))
        dst(dofs_[i]) += static_cast<Number>(values(i));
  }

#define STICTION_INSTANTIATE(Number)                                                   \
  template Eigen::VectorXd DofSubset::restriction(const LA::VectorOf<Number> &) const; \
  template void DofSubset::add_extension(const Eigen::VectorXd &,                      \
                                         LA::VectorOf<Number> &) const;
  STICTION_INSTANTIATE(float)
  STICTION_INSTANTIATE(double)
#undef STICTION_INSTANTIATE
} // namespace stiction
