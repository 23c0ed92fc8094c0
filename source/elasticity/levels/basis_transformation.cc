#include "slave_blocks.h"

#include <stiction/base/all_gather.h>
#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/levels/level_transfer.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/base/partitioner.h>

#include <set>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Dofs   = BasisTransformation::Dofs;
    using Matrix = BasisTransformation::Matrix;

    // Of what is 1 or 0.
    constexpr double rounding = 1e-12;

    // More nodes than this do not count from each other one by one, but in a circle.
    constexpr unsigned int longest_chain = 50;

    // A matrix at each node, empty: the identity.
    Eigen::VectorXd times(const std::vector<Eigen::Matrix3d> &matrices, Eigen::VectorXd x)
    {
      for (std::size_t i = 0; i < matrices.size(); ++i)
        {
          auto at_node = x.segment<3>(3 * static_cast<Eigen::Index>(i));
          at_node      = (matrices[i] * at_node).eval();
        }
      return x;
    }

    Matrix block_diagonal(const std::vector<Eigen::Matrix3d> &blocks)
    {
      std::vector<Eigen::Triplet<double>> entries;
      for (std::size_t i = 0; i < blocks.size(); ++i)
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            if (blocks[i](a, b) != 0.)
              entries.emplace_back(3 * i + a, 3 * i + b, blocks[i](a, b));
      const auto n = 3 * static_cast<Eigen::Index>(blocks.size());
      Matrix matrix(n, n);
      matrix.setFromTriplets(entries.begin(), entries.end());
      return matrix;
    }

    // Weights of nodes as those of their unknowns, three each.
    Matrix of_unknowns(const std::vector<Eigen::Triplet<double>> &weights,
                       const std::size_t n_rows, const std::size_t n_columns)
    {
      std::vector<Eigen::Triplet<double>> entries;
      for (const auto &weight : weights)
        for (Eigen::Index c = 0; c < 3; ++c)
          entries.emplace_back(3 * weight.row() + c, 3 * weight.col() + c,
                               weight.value());
      Matrix matrix(3 * static_cast<Eigen::Index>(n_rows),
                    3 * static_cast<Eigen::Index>(n_columns));
      matrix.setFromTriplets(entries.begin(), entries.end());
      return matrix;
    }

    // The three rows of some slaves, those of the others empty.
    Matrix rows_of(const Matrix &N, const std::vector<bool> &slaves)
    {
      Matrix rows(N.rows(), N.cols());
      for (Eigen::Index k = 0; k < N.rows(); ++k)
        {
          rows.startVec(k);
          if (slaves[k / 3])
            for (Matrix::InnerIterator entry(N, k); entry; ++entry)
              rows.insertBack(k, entry.col()) = entry.value();
        }
      rows.finalize();
      return rows;
    }

    // Row m: which of the slaves the node m is, three rows and columns each.
    Matrix slaves_among(const Dofs &masters, const Dofs &slaves)
    {
      std::map<types::global_dof_index, std::size_t> row;
      for (std::size_t i = 0; i < slaves.size(); ++i)
        row[slaves[i]] = i;
      std::vector<Eigen::Triplet<double>> entries;
      for (std::size_t j = 0; j < masters.size(); ++j)
        if (const auto slave = row.find(masters[j]); slave != row.end())
          entries.emplace_back(j, slave->second, 1.);
      return of_unknowns(entries, masters.size(), slaves.size());
    }

    // Slaves that follow other slaves follow what else is opposite alone, with the same
    // sum of the weights: a coarse node stands for a patch, where pairs may meet that do
    // not on the mesh itself.
    Matrix without_chains(const Matrix &N, const Dofs &masters, const Dofs &slaves)
    {
      const std::set<types::global_dof_index> are_slaves(slaves.begin(), slaves.end());
      std::vector<Eigen::Triplet<double>> entries;
      for (Eigen::Index i = 0; i < N.rows() / 3; ++i)
        {
          double all = 0., kept = 0.; // of the diagonals of the blocks
          const auto for_each_entry = [&](const auto &callback) {
            for (Eigen::Index a = 0; a < 3; ++a)
              for (Matrix::InnerIterator entry(N, 3 * i + a); entry; ++entry)
                callback(entry, are_slaves.count(masters[entry.col() / 3]) == 0);
          };
          for_each_entry([&](const auto &entry, const bool is_kept) {
            const double weight = entry.row() % 3 == entry.col() % 3 ? entry.value() : 0.;
            all += weight;
            kept += is_kept ? weight : 0.;
          });
          if (!(kept > 0.1 * all))
            continue; // it moves by itself
          for_each_entry([&](const auto &entry, const bool is_kept) {
            if (is_kept)
              entries.emplace_back(entry.row(), entry.col(), all / kept * entry.value());
          });
        }
      Matrix M(N.rows(), N.cols());
      M.setFromTriplets(entries.begin(), entries.end());
      return M;
    }
  } // namespace

  BasisTransformation::BasisTransformation()
    : relation_(std::make_shared<const Relation>())
  {
  }

  BasisTransformation::BasisTransformation(Dofs slaves, Dofs masters, const Matrix &N)
  {
    auto relation   = std::make_shared<Relation>();
    relation->chain = slaves_among(masters, slaves);
    for (Matrix power = N; relation->chain.nonZeros() > 0;)
      {
        power = (N * Matrix(relation->chain * power)).pruned();
        if (power.nonZeros() == 0)
          break;
        if (++relation->n_chained > longest_chain)
          throw CircleOfSlaves("slaves count from each other in a circle");
      }
    relation->slave_dofs  = DofSubset::node_by_node(slaves);
    relation->master_dofs = DofSubset::node_by_node(masters);
    relation->slaves      = std::move(slaves);
    relation->masters     = std::move(masters);
    relation->N           = N;
    relation_             = relation;
    N_                    = N;
    ground_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(relation->masters.size()));
  }

  BasisTransformation::Blocks BasisTransformation::large_blocks_of(
    const std::size_t slave, const double part) const
  {
    return large_blocks(blocks_of(relation_->N, static_cast<Eigen::Index>(slave)), part);
  }

  Matrix BasisTransformation::added() const
  {
    // T − 1 = R N (1 + E (T − 1))
    const Matrix N = R_.empty() ? N_ : Matrix(block_diagonal(R_) * N_);
    Matrix added   = N;
    for (unsigned int k = 0; k < relation_->n_chained; ++k)
      added = N + Matrix(N * Matrix(relation_->chain * added));
    return added;
  }

  Matrix BasisTransformation::large_added(const double part) const
  {
    return without_small_blocks(added(), part);
  }

  Matrix BasisTransformation::springs_of_masters(const Eigen::VectorXd &stiffness,
                                                 const double part) const
  {
    std::vector<bool> counts(springs_.size());
    for (std::size_t i = 0; i < springs_.size(); ++i)
      counts[i] =
        springs_[i].trace() > part * stiffness.segment<3>(3 * Eigen::Index(i)).sum();
    const Matrix N = without_small_blocks(rows_of(N_, counts), part);
    return N.transpose() * Matrix(block_diagonal(springs_) * N);
  }

  BasisTransformation BasisTransformation::coarser(const LevelTransfer &transfer,
                                                   const MeshLevel &fine,
                                                   const MeshLevel &coarse,
                                                   const std::vector<Eigen::Index> &rows,
                                                   const Dofs &slaves) const
  {
    if (is_identity())
      return {};
    const Dofs &finer_masters = relation_->masters;
    // the coarse nodes from which the masters are interpolated
    auto place = fine.zero_vector<double>();
    for (std::size_t j = 0; j < finer_masters.size(); ++j)
      if (place.in_local_range(finer_masters[j]))
        place(finer_masters[j]) = static_cast<double>(j + 1);
    place.update_ghost_values();
    struct Weight
    {
      types::global_dof_index coarse;
      unsigned int fine, n;
    };
    std::vector<Weight> weights;
    transfer.for_each_row(
      [&](const unsigned int i, const unsigned int *nodes, const unsigned int n) {
        if (const double j = place.local_element(3 * i); j > 0.)
          for (unsigned int k = 0; k < n; ++k)
            weights.push_back(
              {coarse.first_dof(nodes[k]), static_cast<unsigned int>(j) - 1, n});
      });
    weights = all_gather(weights, coarse.communicator());
    Dofs masters;
    for (const Weight &weight : weights)
      masters.push_back(weight.coarse);
    sort_once(masters);
    std::vector<Eigen::Triplet<double>> interpolated, chosen;
    Eigen::VectorXd ground =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(masters.size()));
    for (const Weight &weight : weights)
      {
        const std::size_t j = place_in(masters, weight.coarse);
        interpolated.emplace_back(weight.fine, j, 1. / weight.n);
        ground(static_cast<Eigen::Index>(j)) += ground_(weight.fine) / weight.n;
      }
    for (std::size_t i = 0; i < rows.size(); ++i)
      chosen.emplace_back(i, rows[i], 1.);
    const Matrix N =
      Matrix(of_unknowns(chosen, rows.size(), relation_->slaves.size()) * relation_->N) *
      of_unknowns(interpolated, finer_masters.size(), masters.size());
    BasisTransformation basis;
    try
      {
        basis = BasisTransformation(slaves, masters, N);
      }
    catch (const CircleOfSlaves &)
      {
        basis = BasisTransformation(slaves, masters, without_chains(N, masters, slaves));
      }
    basis.ground_ = std::move(ground);
    return basis;
  }

  void BasisTransformation::set_relative_directions(std::vector<Eigen::Matrix3d> R,
                                                    std::vector<Eigen::Matrix3d> springs)
  {
    AssertDimension(R.size(), springs.size());
    R_       = std::move(R);
    springs_ = std::move(springs);
    std::vector<bool> counts(R_.size());
    for (std::size_t i = 0; i < R_.size(); ++i)
      {
        if (R_[i].isZero(rounding)) // 1 less a projection on all directions
          R_[i].setZero();
        counts[i] = !R_[i].isZero(0.) || !springs_[i].isZero(0.);
      }
    N_ = rows_of(relation_->N, counts);
  }

  Eigen::VectorXd BasisTransformation::opposite(const Eigen::VectorXd &of_masters) const
  {
    Eigen::VectorXd moved = N_ * of_masters;
    for (unsigned int k = 0; k < relation_->n_chained; ++k)
      moved = N_ * (of_masters + relation_->chain * times(R_, moved));
    return moved;
  }

  template<typename Number>
  void BasisTransformation::to_absolute(LA::VectorOf<Number> &v) const
  {
    if (!is_identity())
      relation_->slave_dofs.add_extension(
        times(R_, opposite(relation_->master_dofs.restriction(v))), v);
  }

  template<typename Number>
  void BasisTransformation::to_relative(LA::VectorOf<Number> &v) const
  {
    if (is_identity())
      return;
    relation_->slave_dofs.add_extension(
      times(R_, -(N_ * relation_->master_dofs.restriction(v))), v);
  }

  template<typename Number>
  void BasisTransformation::forces_to_relative(LA::VectorOf<Number> &r) const
  {
    if (!is_identity())
      relation_->master_dofs.add_extension(
        on_masters(relation_->slave_dofs.restriction(r), Eigen::VectorXd()), r);
  }

  Eigen::VectorXd BasisTransformation::on_masters(const Eigen::VectorXd &of_slaves,
                                                  const Eigen::VectorXd &of_springs) const
  {
    const auto moved = [&](const Eigen::VectorXd &forces) -> Eigen::VectorXd {
      const Eigen::VectorXd all = times(R_, forces);
      return of_springs.size() == 0 ? all : all - of_springs;
    };
    Eigen::VectorXd change = N_.transpose() * moved(of_slaves);
    for (unsigned int k = 0; k < relation_->n_chained; ++k)
      change = N_.transpose() * moved(of_slaves + relation_->chain.transpose() * change);
    return change;
  }

  template<typename Number>
  void BasisTransformation::forces_to_absolute(LA::VectorOf<Number> &r) const
  {
    if (is_identity())
      return;
    relation_->master_dofs.add_extension(
      -(N_.transpose() * times(R_, relation_->slave_dofs.restriction(r))), r);
  }

  template<typename Number>
  void BasisTransformation::vmult(const StiffnessOperator<Number> &K,
                                  LA::VectorOf<Number> &dst,
                                  const LA::VectorOf<Number> &src) const
  {
    if (is_identity())
      return K.vmult(dst, src);
    const Eigen::VectorXd moved = opposite(relation_->master_dofs.restriction(src));
    auto &u                     = std::get<LA::VectorOf<Number>>(scratch_);
    if (u.size() != src.size())
      u.reinit(src, true);
    u.copy_locally_owned_data_from(src);
    relation_->slave_dofs.add_extension(times(R_, moved), u);
    K.vmult(dst, u);
    if (springs_.empty())
      return forces_to_relative(dst);
    const Eigen::VectorXd forces =
      times(springs_, relation_->slave_dofs.restriction(src) - moved);
    relation_->master_dofs.add_extension(
      on_masters(relation_->slave_dofs.restriction(dst), forces), dst);
    relation_->slave_dofs.add_extension(forces, dst);
  }

  std::vector<Eigen::Matrix3d> BasisTransformation::added_blocks(
    const std::vector<Eigen::Matrix3d> &of_slaves) const
  {
    std::vector<Eigen::Matrix3d> added(masters().size(), Eigen::Matrix3d::Zero());
    for (std::size_t i = 0; i < of_slaves.size(); ++i)
      {
        const Eigen::Matrix3d K = R_[i] * of_slaves[i] * R_[i] + springs_[i];
        for (const auto &[j, N] : blocks_of(N_, static_cast<Eigen::Index>(i)))
          added[j] += N.transpose() * K * N;
      }
    return added;
  }

#define STICTION_INSTANTIATE(Number)                                                   \
  template void BasisTransformation::to_absolute(LA::VectorOf<Number> &) const;        \
  template void BasisTransformation::to_relative(LA::VectorOf<Number> &) const;        \
  template void BasisTransformation::forces_to_relative(LA::VectorOf<Number> &) const; \
  template void BasisTransformation::forces_to_absolute(LA::VectorOf<Number> &) const; \
  template void BasisTransformation::vmult(const StiffnessOperator<Number> &,          \
                                           LA::VectorOf<Number> &,                     \
                                           const LA::VectorOf<Number> &) const;
  STICTION_INSTANTIATE(float)
  STICTION_INSTANTIATE(double)
#undef STICTION_INSTANTIATE
} // namespace stiction
