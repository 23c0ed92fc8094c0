#include <stiction/base/all_gather.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/multigrid/level_transfer.h>
#include <stiction/elasticity/multigrid/basis_transformation.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Dofs   = std::vector<types::global_dof_index>;
    using Matrix = BasisTransformation::Matrix;

    // More nodes than this do not count from each other one by one, but in a circle.
    constexpr unsigned int longest_chain = 50;

    void sum(Eigen::VectorXd &values, MPI_Comm communicator)
    {
      Utilities::MPI::sum(ArrayView<const double>(values.data(), values.size()),
                          communicator, ArrayView<double>(values.data(), values.size()));
    }

    // Three numbers a node, on all ranks.
    template<typename Number>
    Eigen::VectorXd values_at(const Dofs &first_dofs, const LA::VectorOf<Number> &v)
    {
      Eigen::VectorXd values =
        Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(first_dofs.size()));
      const auto first = v.get_partitioner()->local_range().first;
      for (std::size_t i = 0; i < first_dofs.size(); ++i)
        if (v.in_local_range(first_dofs[i]))
          for (unsigned int c = 0; c < 3; ++c)
            values(3 * static_cast<Eigen::Index>(i) + c) =
              v.begin()[first_dofs[i] - first + c];
      sum(values, v.get_mpi_communicator());
      return values;
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
          for (unsigned int c = 0; c < 3; ++c)
            entries.emplace_back(3 * j + c, 3 * slave->second + c, 1.);
      Matrix matrix(3 * static_cast<Eigen::Index>(masters.size()),
                    3 * static_cast<Eigen::Index>(slaves.size()));
      matrix.setFromTriplets(entries.begin(), entries.end());
      return matrix;
    }
  } // namespace

  BasisTransformation::BasisTransformation(Dofs slaves, Dofs masters, Matrix N)
    : slaves_(std::move(slaves))
    , masters_(std::move(masters))
    , N_(std::move(N))
    , added_(N_)
  {
    // T − 1 = N + N E N + ..., E taking slaves to where they are masters
    const Matrix E = slaves_among(masters_, slaves_);
    if (E.nonZeros() == 0)
      return;
    Matrix power = N_;
    for (unsigned int k = 0;; ++k)
      {
        power = (N_ * Matrix(E * power)).pruned();
        if (power.nonZeros() == 0)
          break;
        if (k == longest_chain)
          throw std::invalid_argument("displacements that count from each other in a "
                                      "circle");
        added_ += power;
      }
  }

  BasisTransformation BasisTransformation::coarser(const LevelTransfer &transfer,
                                                   const MeshLevel &fine,
                                                   const MeshLevel &coarse,
                                                   const std::vector<Eigen::Index> &rows,
                                                   const Dofs &slaves) const
  {
    if (masters_.empty())
      return {};
    // the coarse nodes from which the masters are interpolated
    auto place = fine.zero_vector<double>();
    for (std::size_t j = 0; j < masters_.size(); ++j)
      if (place.in_local_range(masters_[j]))
        place(masters_[j]) = static_cast<double>(j + 1);
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
    std::map<types::global_dof_index, std::size_t> column;
    for (const Weight &weight : weights)
      column[weight.coarse] = 0;
    Dofs masters;
    for (auto &[dof, number] : column)
      {
        number = masters.size();
        masters.push_back(dof);
      }
    std::vector<Eigen::Triplet<double>> entries;
    for (const Weight &weight : weights)
      for (unsigned int c = 0; c < 3; ++c)
        entries.emplace_back(3 * weight.fine + c, 3 * column[weight.coarse] + c,
                             1. / weight.n);
    Matrix P(3 * static_cast<Eigen::Index>(masters_.size()),
             3 * static_cast<Eigen::Index>(masters.size()));
    P.setFromTriplets(entries.begin(), entries.end());

    entries.clear();
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        entries.emplace_back(3 * i + c, 3 * rows[i] + c, 1.);
    Matrix chosen(3 * static_cast<Eigen::Index>(rows.size()), N_.rows());
    chosen.setFromTriplets(entries.begin(), entries.end());
    return BasisTransformation(slaves, std::move(masters),
                               Matrix(Matrix(chosen * N_) * P));
  }

  template<typename Number, typename Operator>
  void BasisTransformation::add(const double factor, const Operator &A, const Dofs &to,
                                const Dofs &from, LA::VectorOf<Number> &v)
  {
    if (A.rows() == 0 || A.cols() == 0)
      return;
    const Eigen::VectorXd change = A * values_at(from, v);
    const auto first             = v.get_partitioner()->local_range().first;
    for (std::size_t i = 0; i < to.size(); ++i)
      if (v.in_local_range(to[i]))
        for (unsigned int c = 0; c < 3; ++c)
          v.begin()[to[i] - first + c] += static_cast<Number>(
            factor * change(3 * static_cast<Eigen::Index>(i) + c));
  }

  template<typename Number>
  void BasisTransformation::to_absolute(LA::VectorOf<Number> &v) const
  {
    add(1., added_, slaves_, masters_, v);
  }

  template<typename Number>
  void BasisTransformation::to_relative(LA::VectorOf<Number> &v) const
  {
    add(-1., N_, slaves_, masters_, v);
  }

  template<typename Number>
  void BasisTransformation::forces_to_relative(LA::VectorOf<Number> &r) const
  {
    add(1., added_.transpose(), masters_, slaves_, r);
  }

  template<typename Number>
  void BasisTransformation::forces_to_absolute(LA::VectorOf<Number> &r) const
  {
    add(-1., N_.transpose(), masters_, slaves_, r);
  }

  template<typename Number>
  void BasisTransformation::vmult(const StiffnessOperator<Number> &K,
                                  LA::VectorOf<Number> &dst,
                                  const LA::VectorOf<Number> &src) const
  {
    if (is_identity())
      return K.vmult(dst, src);
    LA::VectorOf<Number> u = src;
    to_absolute(u);
    K.vmult(dst, u);
    forces_to_relative(dst);
  }

  template<typename Number>
  void BasisTransformation::add_to_diagonal_blocks(const MeshLevel &mesh,
                                                   std::vector<Number> &blocks) const
  {
    if (is_identity())
      return;
    const auto is_owned = [&](const types::global_dof_index dof) {
      return mesh.partitioner()->in_local_range(dof);
    };
    using Block = Eigen::Matrix<Number, 3, 3, Eigen::RowMajor>;
    Eigen::VectorXd of_slaves =
      Eigen::VectorXd::Zero(9 * static_cast<Eigen::Index>(slaves_.size()));
    for (std::size_t i = 0; i < slaves_.size(); ++i)
      if (is_owned(slaves_[i]))
        for (unsigned int k = 0; k < 9; ++k)
          of_slaves(9 * static_cast<Eigen::Index>(i) + k) =
            static_cast<double>(blocks[9 * mesh.local_node(slaves_[i]) + k]);
    sum(of_slaves, mesh.communicator());

    const Eigen::SparseMatrix<double> columns = added_;
    for (std::size_t j = 0; j < masters_.size(); ++j)
      if (is_owned(masters_[j]))
        {
          std::map<Eigen::Index, Eigen::Matrix3d> at_slave;
          for (unsigned int b = 0; b < 3; ++b)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(
                   columns, 3 * static_cast<Eigen::Index>(j) + b);
                 entry; ++entry)
              at_slave.try_emplace(entry.row() / 3, Eigen::Matrix3d::Zero())
                .first->second(entry.row() % 3, b) = entry.value();
          Eigen::Map<Block> block(&blocks[9 * mesh.local_node(masters_[j])]);
          for (const auto &[i, N] : at_slave)
            block += (N.transpose() * Eigen::Map<const Eigen::Matrix3d>(&of_slaves(9 * i)) *
                      N)
                       .template cast<Number>();
        }
  }

#define STICTION_INSTANTIATE(Number)                                                     \
  template void BasisTransformation::to_absolute(LA::VectorOf<Number> &) const;          \
  template void BasisTransformation::to_relative(LA::VectorOf<Number> &) const;          \
  template void BasisTransformation::forces_to_relative(LA::VectorOf<Number> &) const;   \
  template void BasisTransformation::forces_to_absolute(LA::VectorOf<Number> &) const;   \
  template void BasisTransformation::vmult(const StiffnessOperator<Number> &,            \
                                           LA::VectorOf<Number> &,                       \
                                           const LA::VectorOf<Number> &) const;          \
  template void BasisTransformation::add_to_diagonal_blocks(const MeshLevel &,           \
                                                            std::vector<Number> &) const;
  STICTION_INSTANTIATE(float)
  STICTION_INSTANTIATE(double)
#undef STICTION_INSTANTIATE
} // namespace stiction
