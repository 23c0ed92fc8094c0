#include <stiction/elasticity/supported_stiffness.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    struct Row
    {
      int n_entries   = 0;
      double *entries = nullptr;
      int *columns    = nullptr; // local
    };

    Row
    row_view(const Epetra_CrsMatrix &matrix, const int i)
    {
      Row row;
      matrix.ExtractMyRowView(i, row.n_entries, row.entries, row.columns);
      return row;
    }

    double
    diagonal_entry(const Epetra_CrsMatrix &matrix, const int i)
    {
      const Row row = row_view(matrix, i);
      for (int k = 0; k < row.n_entries; ++k)
        if (matrix.GCID(row.columns[k]) == matrix.GRID(i))
          return row.entries[k];
      return 0.;
    }
  } // namespace



  SupportedStiffness::SupportedStiffness(
    const LA::SparseMatrix &stiffness,
    const LA::Vector &fixed,
    const std::vector<types::global_dof_index> &supported_nodes)
    : stiffness_(stiffness)
    , matrix_(std::make_unique<LA::SparseMatrix>())
  {
    matrix_->reinit(stiffness);
    for (std::size_t i = 0; i < supported_nodes.size(); ++i)
      support_of_[supported_nodes[i]] = i;
    find_fixed_columns(fixed);

    const Epetra_CrsMatrix &K = stiffness.trilinos_matrix();
    std::array<double, 2> sums{};
    for (int i = 0; i < K.NumMyRows(); ++i)
      {
        const double entry = diagonal_entry(K, i);
        sums[0] += entry;
        sums[1] += entry > 0. ? 1. : 0.;
      }
    Utilities::MPI::sum(ArrayView<const double>(sums.data(), sums.size()),
                        stiffness.get_mpi_communicator(),
                        ArrayView<double>(sums.data(), sums.size()));
    mean_diagonal_ = sums[0] / sums[1];
    set_supports(NodalSupports(supported_nodes.size()));
  }



  SupportedStiffness::~SupportedStiffness() = default;



  std::unique_ptr<LA::SparseMatrix>
  SupportedStiffness::release()
  {
    return std::move(matrix_);
  }



  void
  SupportedStiffness::find_fixed_columns(const LA::Vector &fixed)
  {
    // columns reach beyond the ghosts that vectors have: the matrix joins what
    // cells of other ranks and hanging nodes on them couple
    const Epetra_CrsMatrix &K = stiffness_.trilinos_matrix();
    const IndexSet owned      = fixed.locally_owned_elements();
    std::vector<types::global_dof_index> columns;
    for (int k = 0; k < K.NumMyCols(); ++k)
      columns.push_back(static_cast<types::global_dof_index>(K.GCID(k)));
    std::vector<types::global_dof_index> sorted = columns;
    std::sort(sorted.begin(), sorted.end());
    IndexSet relevant(owned.size());
    relevant.add_indices(sorted.begin(), sorted.end());
    relevant.add_indices(owned);

    LA::Vector with_columns(owned, relevant, stiffness_.get_mpi_communicator());
    with_columns.copy_locally_owned_data_from(fixed);
    with_columns.update_ghost_values();
    for (const auto column : columns)
      is_fixed_.push_back(with_columns(column) != 0.);
  }



  Eigen::Matrix3d
  SupportedStiffness::projection(const int column,
                                 const NodalSupports &supports) const
  {
    const auto first_dof = static_cast<types::global_dof_index>(
      stiffness_.trilinos_matrix().GCID(column));
    const auto support = support_of_.find(first_dof);
    Eigen::Matrix3d P  = support == support_of_.end()
                           ? Eigen::Matrix3d::Identity()
                           : supports[support->second].projection;
    for (int c = 0; c < 3; ++c)
      if (is_fixed_[column + c])
        {
          P.row(c).setZero();
          P.col(c).setZero();
        }
    return P;
  }



  void
  SupportedStiffness::set_supports(const NodalSupports &supports)
  {
    matrix_->copy_from(stiffness_);
    const Epetra_CrsMatrix &K = matrix_->trilinos_matrix();
    const Eigen::Matrix3d I   = Eigen::Matrix3d::Identity();

    std::vector<bool> is_held(K.NumMyCols() / 3); // P is not the identity
    std::vector<Eigen::Matrix3d> P(K.NumMyCols() / 3);
    for (int j = 0; j < K.NumMyCols() / 3; ++j)
      {
        P[j]       = projection(3 * j, supports);
        is_held[j] = P[j] != I;
      }

    for (int i = 0; i < K.NumMyRows(); i += 3)
      {
        const std::array<Row, 3> rows = {
          {row_view(K, i), row_view(K, i + 1), row_view(K, i + 2)}};
        if (rows[0].n_entries == 1) // a hanging node
          {
            for (const Row &row : rows)
              row.entries[0] = mean_diagonal_;
            continue;
          }
        const int own = K.LCID(K.GRID(i));
        for (int k = 0; k < rows[0].n_entries; k += 3)
          {
            const int column = rows[0].columns[k];
            if (column % 3 != 0 || rows[1].columns[k] != column ||
                rows[2].columns[k + 2] != column + 2)
              throw std::logic_error(
                "the stiffness matrix does not consist of nodal blocks");
            const int node = column / 3;
            if (!is_held[own / 3] && !is_held[node] && column != own)
              continue;
            Eigen::Matrix3d block;
            for (int a = 0; a < 3; ++a)
              for (int b = 0; b < 3; ++b)
                block(a, b) = rows[a].entries[k + b];
            const Eigen::Vector3d diagonal = block.diagonal();
            block = (P[own / 3] * block * P[node]).eval();
            if (column == own)
              {
                const Eigen::Matrix3d held = I - P[node];
                block += held * diagonal.asDiagonal() * held;
                const auto support = support_of_.find(
                  static_cast<types::global_dof_index>(K.GRID(i)));
                if (support != support_of_.end())
                  block += supports[support->second].spring;
              }
            for (int a = 0; a < 3; ++a)
              for (int b = 0; b < 3; ++b)
                rows[a].entries[k + b] = block(a, b);
          }
      }
  }
} // namespace stiction
