#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>
#include <stiction/elasticity/stiffness/constrained_matrix.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace stiction
{
  using namespace dealii;

  ConstrainedMatrix::ConstrainedMatrix(
    const LA::SparseMatrix &stiffness, const LA::Vector &fixed,
    const std::vector<types::global_dof_index> &supported_nodes)
    : stiffness_(stiffness)
    , matrix_(std::make_unique<LA::SparseMatrix>())
  {
    matrix_->reinit(stiffness);
    for (std::size_t i = 0; i < supported_nodes.size(); ++i)
      support_of_[supported_nodes[i]] = i;
    find_nodes(fixed);

    const Epetra_CrsMatrix &K = stiffness.trilinos_matrix();
    std::array<double, 2> sums{};
    for (int i = 0; i < K.NumMyRows(); ++i)
      {
        const double entry = stiffness.el(K.GRID(i), K.GRID(i));
        sums[0] += entry;
        sums[1] += entry > 0. ? 1. : 0.;
      }
    sum_over_ranks(sums, stiffness.get_mpi_communicator());
    mean_diagonal_ = sums[0] / sums[1];
    set_supports(NodalSupports(supported_nodes.size()));
  }

  ConstrainedMatrix::~ConstrainedMatrix() = default;

  std::unique_ptr<LA::SparseMatrix> ConstrainedMatrix::release()
  {
    return std::move(matrix_);
  }

  void ConstrainedMatrix::find_nodes(const LA::Vector &fixed)
  {
    // columns reach beyond the ghosts that vectors have: the matrix joins what
    // cells of other ranks and hanging nodes on them couple
    const Epetra_CrsMatrix &K = stiffness_.trilinos_matrix();
    std::vector<std::pair<types::global_dof_index, int>> columns;
    for (int k = 0; k < K.NumMyCols(); ++k)
      columns.emplace_back(static_cast<types::global_dof_index>(K.GCID(k)), k);
    std::sort(columns.begin(), columns.end());

    const IndexSet owned = fixed.locally_owned_elements();
    IndexSet relevant    = owned;
    for (const auto &column : columns)
      relevant.add_index(column.first);
    LA::Vector with_columns(owned, relevant, stiffness_.get_mpi_communicator());
    with_columns.copy_locally_owned_data_from(fixed);
    with_columns.update_ghost_values();

    unknown_of_column_.resize(columns.size());
    for (unsigned int k = 0; k < columns.size(); ++k)
      {
        const auto dof = columns[k].first;
        if (k % 3 == 0)
          nodes_.push_back({dof, {}});
        if (dof != nodes_.back().first_dof + k % 3)
          throw std::logic_error("a node has columns for some directions only");
        nodes_.back().is_fixed[k % 3]         = with_columns(dof) != 0.;
        unknown_of_column_[columns[k].second] = k;
      }
  }

  Eigen::Matrix3d ConstrainedMatrix::projection(const Node &node,
                                                const NodalSupports &supports) const
  {
    const auto support = support_of_.find(node.first_dof);
    Eigen::Matrix3d P  = support == support_of_.end()
                           ? Eigen::Matrix3d::Identity()
                           : supports[support->second].projection;
    for (int c = 0; c < 3; ++c)
      if (node.is_fixed[c])
        {
          P.row(c).setZero();
          P.col(c).setZero();
        }
    return P;
  }

  void ConstrainedMatrix::set_supports(const NodalSupports &supports)
  {
    matrix_->copy_from(stiffness_);
    const Epetra_CrsMatrix &K = matrix_->trilinos_matrix();
    const Eigen::Matrix3d I   = Eigen::Matrix3d::Identity();

    const int *const rows = K.RowMap().MyGlobalElements();

    std::vector<Eigen::Matrix3d> P;
    std::vector<bool> is_held; // P is not the identity
    for (const Node &node : nodes_)
      {
        P.push_back(projection(node, supports));
        is_held.push_back(P.back() != I);
      }

    // Most rows have no held node and no support: they stay as they are.
    const auto stays = [&](const int i, const unsigned int own) {
      int n_entries = 0, *columns = nullptr;
      double *values = nullptr;
      K.ExtractMyRowView(i, n_entries, values, columns);
      return !is_held[own] && support_of_.count(nodes_[own].first_dof) == 0 &&
             std::none_of(columns, columns + n_entries, [&](const int column) {
               return is_held[unknown_of_column_[column] / 3];
             });
    };

    // the entries of the three rows of a node, in the order of the unknowns
    std::array<std::vector<std::pair<unsigned int, double *>>, 3> entries;
    for (int i = 0; i < K.NumMyRows(); i += 3)
      {
        const int number       = rows[i];
        const unsigned int own = unknown_of_column_[K.LCID(number)] / 3;
        const bool is_hanging  = matrix_->el(number, number) == 0.;
        if (!is_hanging && stays(i, own))
          continue;
        for (int a = 0; a < 3; ++a)
          {
            int n_entries = 0, *columns = nullptr; // local ones
            double *values = nullptr;
            K.ExtractMyRowView(i + a, n_entries, values, columns);
            entries[a].clear();
            for (int k = 0; k < n_entries; ++k)
              entries[a].emplace_back(unknown_of_column_[columns[k]], values + k);
            std::sort(entries[a].begin(), entries[a].end());
          }
        if (is_hanging)
          {
            for (int a = 0; a < 3; ++a)
              for (const auto &[unknown, entry] : entries[a])
                if (unknown == 3 * own + a)
                  *entry = mean_diagonal_;
            continue;
          }

        for (std::size_t k = 0; k < entries[0].size(); k += 3)
          {
            const unsigned int node = entries[0][k].first / 3;
            if (!is_held[own] && !is_held[node] && node != own)
              continue;
            Eigen::Matrix3d block;
            for (int a = 0; a < 3; ++a)
              for (int b = 0; b < 3; ++b)
                {
                  if (entries[a][k + b].first != 3 * node + b)
                    throw std::logic_error("the stiffness matrix does not "
                                           "consist of nodal blocks");
                  block(a, b) = *entries[a][k + b].second;
                }
            const Eigen::Vector3d diagonal = block.diagonal();
            block                          = (P[own] * block * P[node]).eval();
            if (node == own)
              {
                const Eigen::Matrix3d held = I - P[own];
                block += held * diagonal.asDiagonal() * held;
                const auto support = support_of_.find(nodes_[own].first_dof);
                if (support != support_of_.end())
                  block += supports[support->second].spring;
              }
            for (int a = 0; a < 3; ++a)
              for (int b = 0; b < 3; ++b)
                *entries[a][k + b].second = block(a, b);
          }
      }
  }
} // namespace stiction
