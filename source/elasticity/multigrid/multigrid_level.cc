#include "chebyshev.h"
#include "multigrid_level.h"

#include <stiction/elasticity/mesh/mesh_level.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>

#include <Eigen/LU>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace stiction
{
  namespace
  {
    using Vector = LA::VectorOf<float>;

    Eigen::Map<Eigen::Vector3f> at(Vector &v, const unsigned int node)
    {
      return Eigen::Map<Eigen::Vector3f>(v.begin() + 3 * std::size_t(node));
    }
    Eigen::Map<const Eigen::Vector3f> at(const Vector &v, const unsigned int node)
    {
      return Eigen::Map<const Eigen::Vector3f>(v.begin() + 3 * std::size_t(node));
    }

    // The inverse of P A P + S within the range of P. In double precision, as
    // springs may be stiff.
    Eigen::Matrix3f inverse_in_range(const Eigen::Matrix3d &P, const Eigen::Matrix3d &A,
                                     const Eigen::Matrix3d &S)
    {
      const Eigen::Matrix3d held = (A.trace() / 3.) * (Eigen::Matrix3d::Identity() - P);
      return (P * (P * A * P + S + held).inverse() * P).cast<float>();
    }

    // Of the mean diagonal entry of K at a node: with stiffer springs it is better to
    // count from the other side.
    constexpr double stiff_spring = 2.;
  } // namespace

  Multigrid::Level::Level(const Materials &materials, const MeshLevel &mesh,
                          const double unit, const LA::Vector &fixed,
                          const std::vector<dealii::types::global_dof_index> &first_dofs,
                          BasisTransformation basis)
    : x(mesh.zero_vector<float>())
    , b(mesh.zero_vector<float>())
    , unit_(unit)
    , basis_(std::move(basis))
    , K_(mesh, materials, unit)
    , inverse_diagonal_(mesh.zero_vector<float>())
    , product_(mesh.zero_vector<float>())
    , direction_(mesh.zero_vector<float>())
  {
    const std::vector<float> blocks = K_.diagonal_blocks();
    for (unsigned int i = 0; i < mesh.n_owned_nodes(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        inverse_diagonal_.local_element(3 * i + c) =
          1.f / blocks[9 * std::size_t(i) + 4 * c];
    for (unsigned int k = 0; k < 3 * mesh.n_owned_nodes(); ++k)
      if (fixed.local_element(k) != 0.)
        {
          fixed_.push_back(k);
          inverse_diagonal_.local_element(k) = 0.f;
        }
    for (std::size_t i = 0; i < first_dofs.size(); ++i)
      if (mesh.partitioner()->in_local_range(first_dofs[i]))
        {
          Node node;
          node.local   = mesh.local_node(first_dofs[i]);
          node.in_list = i;
          node.block   = Eigen::Map<const Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(
            &blocks[9 * std::size_t(node.local)]);
          nodes_.push_back(node);
        }
    if (!basis_.is_identity())
      {
        find_masters(mesh, blocks);
        if (has_stiff_slaves(mesh.communicator()))
          master_block_ =
            std::make_unique<MasterBlock>(mesh, materials, unit, fixed, basis_);
      }
    set_supports(NodalSupports(first_dofs.size()));
    largest_eigenvalue_ = 0.f;
  }

  void Multigrid::Level::find_masters(const MeshLevel &mesh,
                                      const std::vector<float> &blocks)
  {
    std::vector<double> of_slaves(9 * basis_.slaves().size(), 0.);
    for (const Node &node : nodes_)
      {
        Eigen::Map<Eigen::Matrix3d> block(&of_slaves[9 * node.in_list]);
        block = node.block.cast<double>();
      }
    dealii::Utilities::MPI::sum(of_slaves, mesh.communicator(), of_slaves);
    for (std::size_t i = 0; i < basis_.slaves().size(); ++i)
      blocks_of_slaves_.emplace_back(
        Eigen::Map<const Eigen::Matrix3d>(&of_slaves[9 * i]));

    std::unordered_map<unsigned int, Node *> in_list;
    for (Node &node : nodes_)
      in_list[node.local] = &node;
    for (std::size_t j = 0; j < basis_.masters().size(); ++j)
      if (mesh.partitioner()->in_local_range(basis_.masters()[j]))
        {
          const unsigned int local = mesh.local_node(basis_.masters()[j]);
          if (const auto node = in_list.find(local); node != in_list.end())
            {
              node->second->in_basis = static_cast<Eigen::Index>(j);
              continue;
            }
          Master master;
          master.local    = local;
          master.in_basis = j;
          for (unsigned int c = 0; c < 3; ++c)
            {
              master.stiffness(c) = blocks[9 * std::size_t(local) + 4 * c];
              master.is_free(c) =
                inverse_diagonal_.local_element(3 * local + c) != 0.f ? 1.f : 0.f;
            }
          masters_.push_back(master);
        }
  }

  bool Multigrid::Level::has_stiff_slaves(MPI_Comm communicator)
  {
    NodalConstraint held;
    held.projection.setZero();
    set_basis(NodalSupports(blocks_of_slaves_.size(), held));
    const std::vector<Eigen::Matrix3d> added = basis_.added_blocks(blocks_of_slaves_);
    double ratio                             = 0.;
    for (const Master &master : masters_)
      ratio = std::max(ratio, added[master.in_basis].trace() / master.stiffness.sum());
    return dealii::Utilities::MPI::max(ratio, communicator) > MasterBlock::much_stiffer;
  }

  void Multigrid::Level::set_basis(const NodalSupports &supports)
  {
    if (basis_.is_identity())
      return;
    std::vector<Eigen::Matrix3d> relative(supports.size(), Eigen::Matrix3d::Identity()),
      soft(supports.size(), Eigen::Matrix3d::Zero());
    for (std::size_t i = 0; i < supports.size(); ++i)
      {
        const Eigen::Matrix3d spring = supports[i].spring / unit_;
        const bool is_stiff =
          spring.trace() > stiff_spring * blocks_of_slaves_[i].trace() / 3.;
        if (!is_stiff)
          {
            relative[i] -= supports[i].projection;
            soft[i] = supports[i].projection * spring * supports[i].projection;
          }
      }
    basis_.set_relative_directions(std::move(relative), std::move(soft));
    const std::vector<Eigen::Matrix3d> added = basis_.added_blocks(blocks_of_slaves_);
    for (const Master &master : masters_)
      at(inverse_diagonal_, master.local) = master.is_free.cwiseQuotient(
        master.stiffness + added[master.in_basis].diagonal().cast<float>());
    for (Node &node : nodes_)
      if (node.in_basis >= 0)
        node.added = added[node.in_basis];
    if (master_block_)
      master_block_->set_basis(basis_);
  }

  float Multigrid::Level::estimate_largest_eigenvalue()
  {
    // conjugate gradients are a Lanczos process
    struct FreeOperator
    {
      const Level &level;
      void vmult(Vector &dst, const Vector &src) const
      {
        level.basis_.vmult(level.K_, dst, src);
        level.project(dst);
      }
    };
    Vector diagonal_inverse = inverse_diagonal_;
    for (const Node &node : nodes_)
      at(diagonal_inverse, node.local) = node.block.diagonal().cwiseInverse();
    const dealii::DiagonalMatrix<Vector> preconditioner(diagonal_inverse);

    // a right-hand side with parts in all eigenvectors
    for (const auto i : b.locally_owned_elements())
      b(i) = static_cast<float>(i % 11) - 5.f;
    project(b);
    double largest = 0.;
    dealii::IterationNumberControl control(15, 1e-6 * b.l2_norm());
    dealii::SolverCG<Vector> lanczos(control);
    lanczos.connect_eigenvalues_slot([&](const std::vector<double> &values) {
      for (const double value : values)
        largest = std::max(largest, value);
    });
    x = 0.f;
    lanczos.solve(FreeOperator{*this}, x, b, preconditioner);
    // the process sees it from below
    return static_cast<float>(1.1 * largest);
  }

  void Multigrid::Level::set_supports(const NodalSupports &supports)
  {
    set_basis(supports);
    for (Node &node : nodes_)
      {
        node.projection        = supports[node.in_list].projection.cast<float>();
        Eigen::Matrix3d spring = supports[node.in_list].spring / unit_;
        Eigen::Matrix3d block  = node.block.cast<double>() + node.added;
        if (!basis_.is_identity()) // which has the soft springs
          {
            spring -= basis_.springs()[node.in_list];
            block += basis_.springs()[node.in_list];
          }
        node.spring  = spring.cast<float>();
        node.inverse = inverse_in_range(supports[node.in_list].projection, block, spring);
        at(inverse_diagonal_, node.local).setZero();
      }
  }

  void Multigrid::Level::project(Vector &v) const
  {
    for (const unsigned int k : fixed_)
      v.local_element(k) = 0.f;
    for (const Node &node : nodes_)
      at(v, node.local) = (node.projection * at(v, node.local)).eval();
  }

  template<Multigrid::Level::Known known>
  void Multigrid::Level::smoothing_step(Vector &x, const Vector &b, const unsigned int k)
  {
    const auto [keep, take] = ChebyshevStep(k, largest_eigenvalue_);

    for (Node &node : nodes_)
      {
        Eigen::Vector3f r = at(b, node.local);
        if (known != Known::nothing)
          r -=
            node.projection * at(product_, node.local) + node.spring * at(x, node.local);
        node.step = take * (node.inverse * r);
      }

    const std::size_t n      = x.locally_owned_size();
    float *const d           = direction_.begin();
    float *const u           = x.begin();
    const float *const rhs   = b.begin();
    const float *const Ku    = product_.begin();
    const float *const scale = inverse_diagonal_.begin();
    for (std::size_t i = 0; i < n; ++i)
      {
        if (known == Known::nothing)
          u[i] = d[i] = take * scale[i] * rhs[i];
        else if (known == Known::no_direction)
          {
            d[i] = take * scale[i] * (rhs[i] - Ku[i]);
            u[i] += d[i];
          }
        else
          {
            d[i] = keep * d[i] + take * scale[i] * (rhs[i] - Ku[i]);
            u[i] += d[i];
          }
      }
    for (const Node &node : nodes_)
      {
        at(direction_, node.local) += node.step;
        at(x, node.local) += node.step;
      }
  }

  void Multigrid::Level::smooth(Vector &x, const Vector &b)
  {
    basis_.vmult(K_, product_, x);
    smoothing_step<Known::no_direction>(x, b, 0);
    smooth_on(x, b);
  }

  void Multigrid::Level::smooth_from_zero(Vector &x, const Vector &b)
  {
    smoothing_step<Known::nothing>(x, b, 0);
    smooth_on(x, b);
  }

  void Multigrid::Level::smooth_on(Vector &x, const Vector &b)
  {
    for (unsigned int k = 1; k < ChebyshevStep::degree; ++k)
      {
        basis_.vmult(K_, product_, x);
        smoothing_step<Known::everything>(x, b, k);
      }
  }

  void Multigrid::Level::solve_masters(Vector &x, const Vector &b)
  {
    if (!master_block_ || master_block_->is_empty())
      return;
    residual(product_, x, b);
    master_block_->add_correction(x, product_);
  }

  void Multigrid::Level::residual(Vector &r, const Vector &x, const Vector &b) const
  {
    basis_.vmult(K_, r, x);
    const std::size_t n    = x.locally_owned_size();
    float *const dst       = r.begin();
    const float *const rhs = b.begin();
    for (std::size_t k = 0; k < n; ++k)
      dst[k] = rhs[k] - dst[k];
    for (const Node &node : nodes_)
      at(r, node.local) -= node.spring * at(x, node.local);
    project(r);
  }
} // namespace stiction
