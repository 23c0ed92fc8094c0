#include <stiction/elasticity/levels/master_block.h>

#include <stiction/base/all_gather.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Dofs          = BasisTransformation::Dofs;
    using SparseColumns = Eigen::SparseMatrix<double>;
    using Entry         = Eigen::Triplet<double, int>;

    // As much_stiffer, of the masters that are in the block where there is one.
    constexpr double heavier = 1.;

    // Column 3i + c: which unknown of the nodes is the component c of the i-th of some.
    SparseColumns places_of(const Dofs &some, const Dofs &nodes)
    {
      std::vector<Entry> entries;
      for (std::size_t i = 0; i < some.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          entries.emplace_back(3 * place_in(nodes, some[i]) + c, 3 * i + c, 1.);
      SparseColumns places(3 * static_cast<Eigen::Index>(nodes.size()),
                           3 * static_cast<Eigen::Index>(some.size()));
      places.setFromTriplets(entries.begin(), entries.end());
      return places;
    }

    using Indices = std::vector<Eigen::Index>;

    // tᵀKt of each column t of T, without the product of all with all.
    Eigen::VectorXd diagonal_of_product(const SparseColumns &K, const SparseColumns &T)
    {
      Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(T.cols());
      Eigen::VectorXd t        = Eigen::VectorXd::Zero(T.rows());
      for (Eigen::Index k = 0; k < T.cols(); ++k)
        {
          for (SparseColumns::InnerIterator entry(T, k); entry; ++entry)
            t(entry.row()) = entry.value();
          for (SparseColumns::InnerIterator entry(T, k); entry; ++entry)
            diagonal(k) += entry.value() * K.col(entry.row()).dot(t);
          for (SparseColumns::InnerIterator entry(T, k); entry; ++entry)
            t(entry.row()) = 0.;
        }
      return diagonal;
    }

    // Those of the identity.
    SparseColumns columns_of(const Indices &chosen, const Eigen::Index size)
    {
      std::vector<Entry> entries;
      for (std::size_t i = 0; i < chosen.size(); ++i)
        entries.emplace_back(chosen[i], i, 1.);
      SparseColumns columns(size, static_cast<Eigen::Index>(chosen.size()));
      columns.setFromTriplets(entries.begin(), entries.end());
      return columns;
    }

    // The rows and columns of K at some nodes.
    SparseColumns assemble(const MeshLevel &mesh, const Materials &materials,
                           const double unit, const Dofs &nodes)
    {
      // of each local node, which of these it is, or hangs on, and by what weight
      std::vector<std::vector<std::pair<unsigned int, double>>> places(
        mesh.n_local_nodes());
      const auto &partitioner = *mesh.partitioner();
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (partitioner.in_local_range(nodes[i]) || partitioner.is_ghost_entry(nodes[i]))
          places[mesh.local_node(nodes[i])] = {{static_cast<unsigned int>(i), 1.}};
      for (const auto &[node, others] : mesh.hanging_nodes())
        for (const auto &[other, weight] : others)
          for (const auto &[place, one] : places[other])
            places[node].emplace_back(place, weight * one);

      std::vector<Entry> entries;
      for_each_element(
        mesh, materials, unit,
        [&](const std::vector<unsigned int> &of_cell, const FullMatrix<double> &K) {
          for (unsigned int i = 0; i < K.m(); ++i)
            for (const auto &[a, weight_a] : places[of_cell[i / 3]])
              for (unsigned int j = 0; j < K.n(); ++j)
                for (const auto &[b, weight_b] : places[of_cell[j / 3]])
                  entries.emplace_back(3 * a + i % 3, 3 * b + j % 3,
                                       weight_a * weight_b * K(i, j));
        },
        [&](const std::vector<unsigned int> &of_cell) {
          return std::any_of(
            of_cell.begin(), of_cell.end(),
            [&](const unsigned int node) { return !places[node].empty(); });
        });
      const auto n = 3 * static_cast<Eigen::Index>(nodes.size());
      SparseColumns K(n, n);
      K.setFromTriplets(entries.begin(), entries.end());
      entries.clear(); // what is sent is the sum of all cells of a rank
      for (Eigen::Index j = 0; j < n; ++j)
        for (SparseColumns::InnerIterator entry(K, j); entry; ++entry)
          entries.emplace_back(entry.row(), entry.col(), entry.value());
      entries = all_gather(entries, mesh.communicator());
      K.setFromTriplets(entries.begin(), entries.end());
      return K;
    }
  } // namespace

  MasterBlock::MasterBlock(const MeshLevel &mesh, const Materials &materials,
                           const double unit, const LA::Vector &fixed,
                           const BasisTransformation &basis)
  {
    const Dofs &masters = basis.masters();
    Dofs slaves         = basis.slaves();
    sort_once(slaves);
    Dofs nodes = slaves;
    nodes.insert(nodes.end(), masters.begin(), masters.end());
    sort_once(nodes);
    K_            = assemble(mesh, materials, unit, nodes);
    of_slaves_    = places_of(basis.slaves(), nodes);
    of_masters_   = places_of(masters, nodes);
    own_diagonal_ = of_masters_.transpose() * Eigen::VectorXd(K_.diagonal());

    felt_stiffness_ = (of_slaves_.transpose() * Eigen::VectorXd(K_.diagonal()))
                        .cwiseMin(own_diagonal_.maxCoeff());

    const Eigen::VectorXd is_fixed = DofSubset::node_by_node(masters).restriction(fixed);
    for (Eigen::Index k = 0; k < is_fixed.size(); ++k)
      is_left_out_.push_back(
        is_fixed(k) != 0. ||
        std::binary_search(slaves.begin(), slaves.end(), masters[k / 3]));
  }

  void MasterBlock::set_basis(const BasisTransformation &basis)
  {
    constexpr double small      = BasisTransformation::small_block;
    const SparseColumns added   = basis.large_added(small);
    const SparseColumns springs = basis.springs_of_masters(felt_stiffness_, small);
    const SparseColumns T       = of_masters_ + SparseColumns(of_slaves_ * added);
    // where nothing is added it is the own diagonal, and the master is not chosen
    const Eigen::VectorXd diagonal =
      diagonal_of_product(K_, T) + Eigen::VectorXd(springs.diagonal());
    Indices chosen;
    Dofs unknowns;
    for (Eigen::Index k = 0; k < diagonal.size(); ++k)
      if (!is_left_out_[k] && diagonal(k) > (1. + heavier) * own_diagonal_(k))
        {
          chosen.push_back(k);
          unknowns.push_back(basis.masters()[k / 3] + k % 3);
        }
    unknowns_ = DofSubset(std::move(unknowns));
    if (is_empty())
      return;
    const SparseColumns M         = columns_of(chosen, T.cols());
    const SparseColumns of_chosen = T * M;
    factors_.compute(
      SparseColumns(of_chosen.transpose() * SparseColumns(K_ * of_chosen)) +
      SparseColumns(M.transpose() * SparseColumns(springs * M)));
    if (factors_.info() != Eigen::Success) // springs of chains are left out
      unknowns_ = DofSubset();
  }

  void MasterBlock::add_correction(LA::VectorOf<float> &x,
                                   const LA::VectorOf<float> &r) const
  {
    unknowns_.add_extension(Eigen::VectorXd(factors_.solve(unknowns_.restriction(r))), x);
  }
} // namespace stiction
