#include <stiction/elasticity/linear_algebra/amg_preconditioner.h>
#include <stiction/elasticity/linear_algebra/dof_subset.h>
#include <stiction/elasticity/linear_algebra/host_vector.h>
#include <stiction/elasticity/linear_algebra/mumps_factorization.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/model/rigid_body_modes.h>
#include <stiction/elasticity/multigrid/coarse_solver.h>
#include <stiction/elasticity/stiffness/constrained_matrix.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <algorithm>
#include <array>

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

    template<typename Nodes>
    Indices first_dofs_of(const MeshLevel &level, const Nodes &nodes)
    {
      Indices dofs;
      for (const unsigned int node : nodes)
        dofs.push_back(level.first_dof(node));
      return dofs;
    }

    bool needs_assembled_stiffness(const LinearElasticity &elasticity,
                                   const MeshLevel &level)
    {
      return !level.is_trilinear() || elasticity.body().n_hanging_nodes() > 0;
    }
  } // namespace

  CoarseSolver::CoarseSolver(const LinearElasticity &elasticity, const MeshLevel &level,
                             const LA::Vector &fixed, const Indices &supported_nodes,
                             const BasisTransformation &basis,
                             const NodalSupports &supports, const bool is_direct)
    : elasticity_(elasticity)
    , level_(level)
    , fixed_(std::make_unique<LA::Vector>(fixed))
    , supported_nodes_(supported_nodes)
    , basis_(basis)
    , added_(basis.added())
    , always_direct_(is_direct)
    , host_(std::make_unique<HostVector>(fixed))
  {
    fixed_->update_ghost_values();
    for (std::size_t i = 0; i < supported_nodes.size(); ++i)
      support_of_[supported_nodes[i]] = i;
    for (std::size_t i = 0; i < basis.slaves().size(); ++i)
      slave_of_[basis.slaves()[i]] = i;
    const Eigen::VectorXd is_fixed =
      DofSubset(unknowns_of(basis.masters())).restriction(fixed);
    for (std::size_t j = 0; j < basis.masters().size(); ++j)
      for (unsigned int c = 0; c < 3; ++c)
        is_fixed_opposite_[basis.masters()[j]][c] =
          is_fixed(3 * static_cast<Eigen::Index>(j) + c) != 0.;

    if (needs_assembled_stiffness(elasticity, level)) // the level is the mesh itself
      {
        stiffness_ = elasticity.assemble();
        assembled_ =
          std::make_unique<ConstrainedMatrix>(*stiffness_, fixed, supported_nodes);
      }
    else if (level_.n_dofs() > max_dense)
      make_pattern();
    set_supports(supports);
  }

  bool CoarseSolver::can_be_set_up(const LinearElasticity &elasticity,
                                   const MeshLevel &level,
                                   const BasisTransformation &basis)
  {
    return basis.is_identity() || !needs_assembled_stiffness(elasticity, level);
  }

  CoarseSolver::~CoarseSolver() = default;

  void CoarseSolver::make_pattern()
  {
    const IndexSet &owned = level_.partitioner()->locally_owned_range();
    IndexSet relevant     = owned;
    relevant.add_indices(level_.partitioner()->ghost_indices());
    for (const auto dof : unknowns_of(basis_.masters()))
      relevant.add_index(dof);

    DynamicSparsityPattern pattern(relevant);
    Eigen::MatrixXd T;
    level_.for_each_cell([&](const HexahedralCell &cell) {
      const Indices indices = unknowns_of(nodes_of(first_dofs_of(level_, cell.nodes), T));
      for (const auto row : indices)
        pattern.add_entries(row, indices.begin(), indices.end());
    });
    SparsityTools::distribute_sparsity_pattern(pattern, owned, level_.communicator(),
                                               relevant);
    matrix_ = std::make_unique<LA::SparseMatrix>();
    matrix_->reinit(owned, owned, pattern, level_.communicator());
  }

  void CoarseSolver::set_supports(const NodalSupports &supports)
  {
    direct_.reset(); // before the new one
    amg_.reset();
    if (assembled_)
      {
        assembled_->set_supports(supports);
        factorize(assembled_->matrix(), supports);
        return;
      }
    if (level_.n_dofs() <= max_dense)
      {
        factorize_dense(supports);
        return;
      }
    *matrix_ = 0.;
    assemble(supports, [&](const Indices &indices, const auto &matrix) {
      matrix_->add(indices, matrix);
    });
    matrix_->compress(VectorOperation::add);
    factorize(*matrix_, supports);
  }

  void CoarseSolver::factorize(const LA::SparseMatrix &matrix,
                               const NodalSupports &supports)
  {
    if (always_direct_ || level_.n_dofs() <= max_direct)
      direct_ = std::make_unique<MumpsFactorization>(matrix, 3);
    else
      amg_ = std::make_unique<AmgPreconditioner>(matrix, held_modes(supports));
  }

  void CoarseSolver::factorize_dense(const NodalSupports &supports)
  {
    const auto n           = static_cast<Eigen::Index>(level_.n_dofs());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    assemble(supports, [&](const Indices &indices, const auto &block) {
      for (unsigned int i = 0; i < indices.size(); ++i)
        for (unsigned int j = 0; j < indices.size(); ++j)
          matrix(indices[i], indices[j]) += block(i, j);
    });
    Utilities::MPI::sum(ArrayView<const double>(matrix.data(), matrix.size()),
                        level_.communicator(),
                        ArrayView<double>(matrix.data(), matrix.size()));
    dense_ = std::make_unique<Eigen::LLT<Eigen::MatrixXd>>(matrix);
  }

  Indices CoarseSolver::nodes_of(const Indices &of_cell, Eigen::MatrixXd &T) const
  {
    Indices nodes = of_cell;
    T.setIdentity(3 * static_cast<Eigen::Index>(of_cell.size()),
                  3 * static_cast<Eigen::Index>(of_cell.size()));
    for (std::size_t v = 0; v < of_cell.size(); ++v)
      if (const auto slave = slave_of_.find(of_cell[v]); slave != slave_of_.end())
        for (Eigen::Index a = 0; a < 3; ++a)
          for (BasisTransformation::Matrix::InnerIterator entry(
                 added_, 3 * static_cast<Eigen::Index>(slave->second) + a);
               entry; ++entry)
            {
              const auto master = basis_.masters()[entry.col() / 3];
              const auto place =
                std::find(nodes.begin(), nodes.end(), master) - nodes.begin();
              if (place == static_cast<std::ptrdiff_t>(nodes.size()))
                {
                  nodes.push_back(master);
                  T.conservativeResize(Eigen::NoChange, T.cols() + 3);
                  T.rightCols<3>().setZero();
                }
              T(3 * static_cast<Eigen::Index>(v) + a, 3 * place + entry.col() % 3) +=
                entry.value();
            }
    return nodes;
  }

  Eigen::Matrix3d CoarseSolver::projection(const types::global_dof_index first_dof,
                                           const NodalSupports &supports) const
  {
    const auto support  = support_of_.find(first_dof);
    Eigen::Matrix3d P   = support == support_of_.end()
                            ? Eigen::Matrix3d::Identity()
                            : supports[support->second].projection;
    const auto opposite = is_fixed_opposite_.find(first_dof);
    for (unsigned int c = 0; c < 3; ++c)
      if (opposite != is_fixed_opposite_.end()
            ? opposite->second[c]
            : fixed_->local_element(3 * level_.local_node(first_dof) + c) != 0.)
        {
          P.row(c).setZero();
          P.col(c).setZero();
        }
    return P;
  }

  void CoarseSolver::assemble(const NodalSupports &supports, const Add &add) const
  {
    Eigen::MatrixXd T, K;
    FullMatrix<double> held;
    for_each_element(
      level_, elasticity_.materials(), 1., [&](const auto &of_cell, const auto &free) {
        const Indices nodes = nodes_of(first_dofs_of(level_, of_cell), T);
        const auto n        = static_cast<unsigned int>(nodes.size());
        K                   = Eigen::Map<const Eigen::MatrixXd>(&free(0, 0), 24, 24);
        if (n > of_cell.size())
          K = (T.transpose() * K * T).eval();

        std::vector<Eigen::Matrix3d> P;
        for (const auto node : nodes)
          P.push_back(projection(node, supports));
        held.reinit(3 * n, 3 * n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            {
              Eigen::Matrix3d block = P[i] * K.block<3, 3>(3 * i, 3 * j) * P[j];
              // held directions keep a diagonal of the size of the others
              if (i == j)
                block += K(3 * i, 3 * i) * (Eigen::Matrix3d::Identity() - P[i]);
              for (unsigned int a = 0; a < 3; ++a)
                for (unsigned int b = 0; b < 3; ++b)
                  held(3 * i + a, 3 * j + b) = block(a, b);
            }
        add(unknowns_of(nodes), held);
      });
    FullMatrix<double> entries(3, 3);
    const auto add_spring = [&](const auto dof, const Eigen::Matrix3d &spring) {
      if (!level_.partitioner()->in_local_range(dof))
        return;
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          entries(a, b) = spring(a, b);
      add({dof, dof + 1, dof + 2}, entries);
    };
    for (std::size_t i = 0; i < supports.size(); ++i)
      add_spring(supported_nodes_[i], supports[i].spring);
    for (Eigen::Index j = 0; j < basis_.ground().size(); ++j)
      {
        const auto dof = basis_.masters()[j];
        add_spring(dof, basis_.ground()(j) * projection(dof, supports));
      }
  }

  std::vector<std::vector<double>> CoarseSolver::held_modes(
    const NodalSupports &supports) const
  {
    auto modes = rigid_body_modes(elasticity_.body(), level_.node_positions());
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
        Utilities::MPI::sum(ArrayView<const double>(x.data(), x.size()),
                            level_.communicator(), ArrayView<double>(x.data(), x.size()));
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
