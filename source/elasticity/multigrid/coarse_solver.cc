#include <stiction/elasticity/linear_algebra/amg_preconditioner.h>
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

    template<typename Nodes>
    Indices indices_of(const MeshLevel &level, const Nodes &nodes)
    {
      Indices indices(24);
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int c = 0; c < 3; ++c)
          indices[3 * v + c] = level.first_dof(nodes[v]) + c;
      return indices;
    }
  } // namespace

  CoarseSolver::CoarseSolver(const LinearElasticity &elasticity, const MeshLevel &level,
                             const LA::Vector &fixed, const Indices &supported_nodes,
                             const NodalSupports &supports, const bool is_direct)
    : elasticity_(elasticity)
    , level_(level)
    , fixed_(std::make_unique<LA::Vector>(fixed))
    , supported_nodes_(supported_nodes)
    , always_direct_(is_direct)
    , host_(std::make_unique<HostVector>(fixed))
  {
    fixed_->update_ghost_values();
    for (std::size_t i = 0; i < supported_nodes.size(); ++i)
      {
        const auto dof = supported_nodes[i];
        if (level.partitioner()->in_local_range(dof) ||
            level.partitioner()->is_ghost_entry(dof))
          support_of_[level.local_node(dof)] = i;
      }
    const LA::SparseMatrix *K = elasticity.stiffness().matrix();
    if (K == nullptr &&
        (!level.is_trilinear() || elasticity.body().n_hanging_nodes() > 0))
      {
        own_stiffness_ = elasticity.assemble();
        K              = own_stiffness_.get();
      }
    if (K != nullptr) // then the level is the mesh itself
      assembled_ = std::make_unique<ConstrainedMatrix>(*K, fixed, supported_nodes);
    else if (level_.n_dofs() > max_dense)
      make_pattern();
    set_supports(supports);
  }

  CoarseSolver::~CoarseSolver() = default;

  void CoarseSolver::make_pattern()
  {
    const IndexSet &owned = level_.partitioner()->locally_owned_range();
    IndexSet relevant     = owned;
    relevant.add_indices(level_.partitioner()->ghost_indices());

    DynamicSparsityPattern pattern(relevant);
    level_.for_each_cell([&](const HexahedralCell &cell) {
      const Indices indices = indices_of(level_, cell.nodes);
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

  void CoarseSolver::assemble(const NodalSupports &supports, const Add &add) const
  {
    FullMatrix<double> held;
    for_each_element(
      level_, elasticity_.materials(), 1., [&](const auto &nodes, const auto &free) {
        held = free;

        std::array<Eigen::Matrix3d, 8> P;
        bool is_held = false;
        for (unsigned int v = 0; v < 8; ++v)
          {
            const auto support = support_of_.find(nodes[v]);
            P[v] = support == support_of_.end() ? Eigen::Matrix3d::Identity()
                                                : supports[support->second].projection;
            for (unsigned int c = 0; c < 3; ++c)
              if (fixed_->local_element(3 * nodes[v] + c) != 0.)
                {
                  P[v].row(c).setZero();
                  P[v].col(c).setZero();
                }
            is_held = is_held || P[v] != Eigen::Matrix3d::Identity();
          }
        for (unsigned int i = 0; is_held && i < 8; ++i)
          for (unsigned int j = 0; j < 8; ++j)
            {
              Eigen::Matrix3d block;
              for (unsigned int a = 0; a < 3; ++a)
                for (unsigned int b = 0; b < 3; ++b)
                  block(a, b) = free(3 * i + a, 3 * j + b);
              block = (P[i] * block * P[j]).eval();
              // held directions keep a diagonal of the size of the others
              if (i == j)
                block += free(3 * i, 3 * i) * (Eigen::Matrix3d::Identity() - P[i]);
              for (unsigned int a = 0; a < 3; ++a)
                for (unsigned int b = 0; b < 3; ++b)
                  held(3 * i + a, 3 * j + b) = block(a, b);
            }
        add(indices_of(level_, nodes), held);
      });
    FullMatrix<double> spring(3, 3);
    for (std::size_t i = 0; i < supports.size(); ++i)
      {
        const auto dof = supported_nodes_[i];
        if (!level_.partitioner()->in_local_range(dof))
          continue;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            spring(a, b) = supports[i].spring(a, b);
        add({dof, dof + 1, dof + 2}, spring);
      }
  }

  std::vector<std::vector<double>> CoarseSolver::held_modes(
    const NodalSupports &supports) const
  {
    auto modes = rigid_body_modes(elasticity_.body(), level_.node_positions());
    for (std::vector<double> &mode : modes)
      {
        for (const auto &support : support_of_)
          if (support.first < level_.n_owned_nodes())
            {
              Eigen::Map<Eigen::Vector3d> at_node(&mode[3 * support.first]);
              at_node = (supports[support.second].projection * at_node).eval();
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
