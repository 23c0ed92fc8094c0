#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>
#include <stiction/elasticity/stiffness/constrained_matrix.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The places of the columns of a row in the order of unknowns: columns of other
    // ranks may be out of it.
    void order_by_unknowns(const int *columns, const int n_columns,
                           const std::vector<unsigned int> &unknown_of_column,
                           std::vector<int> &order)
    {
      order.resize(static_cast<std::size_t>(n_columns));
      std::iota(order.begin(), order.end(), 0);
      const auto is_before = [&](const int k, const int l) {
        return unknown_of_column[columns[k]] < unknown_of_column[columns[l]];
      };
      if (!std::is_sorted(order.begin(), order.end(), is_before))
        std::sort(order.begin(), order.end(), is_before);
    }
  } // namespace

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

  Eigen::Matrix3d ConstrainedMatrix::constrained_diagonal(
    const Eigen::Matrix3d &block, const Node &node, const Eigen::Matrix3d &P,
    const NodalSupports &supports) const
  {
    const Eigen::Matrix3d held = Eigen::Matrix3d::Identity() - P;
    Eigen::Matrix3d diagonal =
      P * block * P + held * block.diagonal().asDiagonal() * held;
    const auto support = support_of_.find(node.first_dof);
    if (support != support_of_.end())
      diagonal += supports[support->second].spring;
    return diagonal;
  }

  void ConstrainedMatrix::set_supports(const NodalSupports &supports)
  {
    matrix_->copy_from(stiffness_);
    const Epetra_CrsMatrix &K = matrix_->trilinos_matrix();

    std::vector<Eigen::Matrix3d> P;
    std::vector<bool> is_held; // P is not the identity
    for (const Node &node : nodes_)
      {
        P.push_back(projection(node, supports));
        is_held.push_back(P.back() != Eigen::Matrix3d::Identity());
      }

    std::vector<int> order; // of the columns of a row
    const int *const rows = K.RowMap().MyGlobalElements();
    for (int i = 0; i < K.NumMyRows(); i += 3)
      {
        const unsigned int own = unknown_of_column_[K.LCID(rows[i])] / 3;
        int n_entries = 0, *columns = nullptr; // local ones
        std::array<double *, 3> values{};
        const bool is_hanging = matrix_->el(rows[i], rows[i]) == 0.;
        bool is_nodal         = true;
        for (int a = 0; a < 3; ++a)
          {
            const int n_before = n_entries;
            K.ExtractMyRowView(i + a, n_entries, values[a], columns);
            is_nodal = is_nodal && (a == 0 || n_entries == n_before);
            if (is_hanging)
              for (int k = 0; k < n_entries; ++k)
                if (unknown_of_column_[columns[k]] == 3 * own + a)
                  values[a][k] = mean_diagonal_;
          }
        if (is_hanging)
          continue;

        // the three rows of others have the same columns, three for each node
        order_by_unknowns(columns, n_entries, unknown_of_column_, order);
        const auto node_of = [&](const int k) {
          return unknown_of_column_[columns[order[k]]] / 3;
        };
        for (int k = 0; k < n_entries; k += 3)
          {
            const unsigned int node = node_of(k);
            if (!is_held[own] && !is_held[node] && node != own)
              continue;
            if (!is_nodal || k + 2 >= n_entries || node_of(k + 1) != node ||
                node_of(k + 2) != node)
              throw std::logic_error("the stiffness matrix does not "
                                     "consist of nodal blocks");
            Eigen::Matrix3d block;
            for (int a = 0; a < 3; ++a)
              for (int b = 0; b < 3; ++b)
                block(a, b) = values[a][order[k + b]];
            block = node == own
                      ? constrained_diagonal(block, nodes_[own], P[own], supports)
                      : (P[own] * block * P[node]).eval();
            for (int a = 0; a < 3; ++a)
              for (int b = 0; b < 3; ++b)
                values[a][order[k + b]] = block(a, b);
          }
      }
  }
} // namespace stiction
