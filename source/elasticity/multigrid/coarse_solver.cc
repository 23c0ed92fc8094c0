#include <stiction/elasticity/linear_algebra/amg_preconditioner.h>
#include <stiction/elasticity/linear_algebra/host_vector.h>
#include <stiction/elasticity/linear_algebra/matrix_rows.h>
#include <stiction/elasticity/linear_algebra/mumps_factorization.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/model/rigid_body_modes.h>
#include <stiction/elasticity/multigrid/coarse_solver.h>
#include <stiction/elasticity/stiffness/assembled_stiffness.h>
#include <stiction/elasticity/stiffness/constrained_matrix.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <EpetraExt_MatrixMatrix.h>

#include <algorithm>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Up to this order a dense factorisation on every rank is the fastest, and
    // needs no setting up.
    constexpr types::global_dof_index max_dense = 400;

    // Above this order a V-cycle of algebraic multigrid is set up faster than
    // MUMPS factorises.
    constexpr types::global_dof_index max_direct = 4000;

    using Indices = std::vector<types::global_dof_index>;

    // The three unknowns of each node.
    Indices unknowns_of(const Indices &first_dofs)
    {
      Indices indices;
      for (const auto dof : first_dofs)
        for (unsigned int c = 0; c < 3; ++c)
          indices.push_back(dof + c);
      return indices;
    }

    // The same matrix with whole blocks of nodes, one on the diagonal for each of them:
    // products of matrices leave out entries that are zero, and all rows of hanging
    // nodes.
    std::unique_ptr<LA::SparseMatrix> of_nodal_blocks(const Epetra_CrsMatrix &product,
                                                      const IndexSet &owned,
                                                      MPI_Comm communicator)
    {
      DynamicSparsityPattern pattern(owned);
      for (const auto row : owned)
        if (row % 3 == 0)
          {
            Indices nodes = {row};
            for (unsigned int c = 0; c < 3; ++c)
              for_each_entry(product, row + c, [&](const auto column, const double) {
                if (const auto node = column / 3 * 3; nodes.back() != node)
                  nodes.push_back(node);
              });
            sort_once(nodes);
            const Indices columns = unknowns_of(nodes);
            for (unsigned int c = 0; c < 3; ++c)
              pattern.add_entries(row + c, columns.begin(), columns.end(), true);
          }
      auto matrix = std::make_unique<LA::SparseMatrix>();
      matrix->reinit(owned, owned, pattern, communicator);
      for (const auto row : owned)
        {
          Indices columns;
          std::vector<double> values;
          for_each_entry(product, row, [&](const auto column, const double value) {
            columns.push_back(column);
            values.push_back(value);
          });
          matrix->set(row, columns, values);
        }
      matrix->compress(VectorOperation::insert);
      return matrix;
    }

    // TᵀKT.
    std::unique_ptr<LA::SparseMatrix> transformed(const LA::SparseMatrix &K,
                                                  const BasisTransformation &basis,
                                                  const MeshLevel &level)
    {
      const IndexSet &owned = level.partitioner()->locally_owned_range();
      const auto added      = // of T − 1
        basis.large_added(BasisTransformation::small_block);
      const Indices rows             = unknowns_of(basis.slaves()),
                    columns          = unknowns_of(basis.masters());
      const auto for_each_entry_of_T = [&](const auto &take) {
        for (const auto dof : owned)
          take(dof, dof, 1.);
        for (Eigen::Index i = 0; i < added.outerSize(); ++i)
          if (owned.is_element(rows[i]))
            for (BasisTransformation::Matrix::InnerIterator entry(added, i); entry;
                 ++entry)
              take(rows[i], columns[entry.col()], entry.value());
      };
      DynamicSparsityPattern pattern(owned);
      for_each_entry_of_T([&](const auto row, const auto column, const double) {
        pattern.add(row, column);
      });
      LA::SparseMatrix T;
      T.reinit(owned, owned, pattern, level.communicator());
      for_each_entry_of_T([&](const auto row, const auto column, const double value) {
        T.add(row, column, value);
      });
      T.compress(VectorOperation::add);
      const Epetra_CrsMatrix &left = T.trilinos_matrix();
      Epetra_CrsMatrix KT(Copy, left.RowMap(), 0), TKT(Copy, left.RowMap(), 0);
      EpetraExt::MatrixMatrix::Multiply(K.trilinos_matrix(), false, left, false, KT);
      EpetraExt::MatrixMatrix::Multiply(left, true, KT, false, TKT);
      return of_nodal_blocks(TKT, owned, level.communicator());
    }
  } // namespace

  CoarseSolver::CoarseSolver(const Materials &materials, const MeshLevel &level,
                             const LA::Vector &fixed, const Indices &supported_nodes,
                             const BasisTransformation &basis,
                             const NodalSupports &supports, const bool is_direct)
    : level_(level)
    , fixed_(std::make_unique<LA::Vector>(fixed))
    , ground_(basis.ground())
    , always_direct_(is_direct)
    , host_(std::make_unique<HostVector>(fixed))
  {
    Indices nodes = supported_nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      support_of_[nodes[i]] = i;
    for (const auto dof : basis.masters())
      {
        const auto [place, is_new] = support_of_.emplace(dof, nodes.size());
        if (is_new)
          nodes.push_back(dof);
        masters_.push_back(place->second);
      }
    n_supported_ = nodes.size();
    stiffness_   = assemble_stiffness(level, materials, level.body().hanging_nodes());
    if (!basis.is_identity())
      stiffness_ = transformed(*stiffness_, basis, level);
    constrained_ = std::make_unique<ConstrainedMatrix>(*stiffness_, fixed, nodes);
    set_supports(supports);
  }

  CoarseSolver::~CoarseSolver() = default;

  void CoarseSolver::set_supports(const NodalSupports &supports)
  {
    amg_.reset(); // before the new one
    NodalSupports all = supports;
    all.resize(n_supported_);
    for (std::size_t j = 0; j < masters_.size(); ++j)
      all[masters_[j]].spring +=
        ground_(static_cast<Eigen::Index>(j)) * all[masters_[j]].projection;
    constrained_->set_supports(all);
    const LA::SparseMatrix &matrix = constrained_->matrix();
    if (level_.n_dofs() <= max_dense)
      factorize_dense(matrix);
    else if (direct_)
      direct_->refactorize(matrix);
    else if (always_direct_ || level_.n_dofs() <= max_direct)
      direct_ = std::make_unique<MumpsFactorization>(matrix);
    else
      amg_ = std::make_unique<AmgPreconditioner>(matrix, held_modes(all));
  }

  void CoarseSolver::factorize_dense(const LA::SparseMatrix &matrix)
  {
    const auto n          = static_cast<Eigen::Index>(level_.n_dofs());
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
    for (const auto row : level_.partitioner()->locally_owned_range())
      for_each_entry(
        matrix.trilinos_matrix(), row,
        [&](const auto column, const double value) { dense(row, column) = value; });
    sum_over_ranks(dense, level_.communicator());
    dense_ = std::make_unique<Eigen::LLT<Eigen::MatrixXd>>(dense);
  }

  std::vector<std::vector<double>> CoarseSolver::held_modes(
    const NodalSupports &supports) const
  {
    auto modes = rigid_body_modes(level_.body(), level_.node_positions());
    for (std::vector<double> &mode : modes)
      {
        for (const auto &[dof, place] : support_of_)
          if (level_.partitioner()->in_local_range(dof))
            {
              Eigen::Map<Eigen::Vector3d> at_node(&mode[3 * level_.local_node(dof)]);
              at_node = (supports[place].projection * at_node).eval();
            }
        for (std::size_t k = 0; k < mode.size(); ++k)
          if (fixed_->local_element(static_cast<unsigned int>(k)) != 0.)
            mode[k] = 0.;
      }
    return modes;
  }

  void CoarseSolver::vmult(LA::Vector &dst, const LA::Vector &src) const
  {
    if (amg_)
      {
        amg_->vmult(dst, src);
        return;
      }
    if (dense_)
      {
        const IndexSet owned = src.locally_owned_elements();
        Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(src.size()));
        for (const auto i : owned)
          x(i) = src(i);
        sum_over_ranks(x, level_.communicator());
        dense_->solveInPlace(x);
        for (const auto i : owned)
          dst(i) = x(i);
        return;
      }
    Eigen::VectorXd x = host_->gather(src);
    direct_->solve(x);
    host_->scatter(x, dst);
  }
} // namespace stiction
