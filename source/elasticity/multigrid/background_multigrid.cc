#include "background_grid.h"
#include "springs_between_bodies.h"

#include <stiction/base/all_gather.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/multigrid/background_grids.h>
#include <stiction/elasticity/multigrid/background_multigrid.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <unordered_map>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Interpolation = BackgroundMultigrid::Interpolation;
    using Nodes         = std::vector<std::array<double, 3>>;
    using Cells         = std::vector<std::array<unsigned int, 8>>;

    // Calls back with the nodes of every cell, in their numbering on the whole mesh.
    template<typename Callback>
    void for_each_cell(const MeshLevel &mesh, const Callback &callback)
    {
      mesh.for_each_node_list([&](std::vector<unsigned int> nodes) {
        for (unsigned int &node : nodes)
          node = static_cast<unsigned int>(mesh.first_dof(node) / 3);
        callback(nodes);
      });
    }

    // From the nodes of the whole mesh. A cell of degree 2 is eight with its nodes.
    std::vector<Interpolation> make_grids(const MeshLevel &mesh)
    {
      Nodes nodes;
      for (const Point<3> &p : mesh.node_positions())
        nodes.push_back({{p[0], p[1], p[2]}});
      Cells cells;
      for_each_cell(mesh, [&](const std::vector<unsigned int> &of_cell) {
        const unsigned int n = mesh.is_trilinear() ? 1 : 2; // along an edge
        for (unsigned int child = 0; child < n * n * n; ++child)
          {
            const unsigned int first =
              child % n + (n + 1) * (child / n % n + (n + 1) * (child / (n * n)));
            cells.emplace_back();
            for (unsigned int v = 0; v < 8; ++v)
              cells.back()[v] = of_cell[first + (v & 1) + (n + 1) * (v >> 1 & 1) +
                                        (n + 1) * (n + 1) * (v >> 2)];
          }
      });
      return background_grids(all_gather(nodes, mesh.communicator()),
                              all_gather(cells, mesh.communicator()));
    }

    Interpolation rows_of(const Interpolation &matrix,
                          const std::vector<unsigned int> &numbers)
    {
      std::vector<Eigen::Triplet<float>> entries;
      for (std::size_t i = 0; i < numbers.size(); ++i)
        for (Interpolation::InnerIterator entry(matrix, numbers[i]); entry; ++entry)
          entries.emplace_back(i, entry.col(), entry.value());
      Interpolation rows(static_cast<Eigen::Index>(numbers.size()), matrix.cols());
      rows.setFromTriplets(entries.begin(), entries.end());
      return rows;
    }

    // The vertices from which these nodes, or vertices, are interpolated.
    std::vector<unsigned int> touched_by(const std::vector<unsigned int> &numbers,
                                         const Interpolation &matrix)
    {
      std::vector<unsigned int> columns;
      for (const unsigned int i : numbers)
        for (Interpolation::InnerIterator entry(matrix, i); entry; ++entry)
          columns.push_back(static_cast<unsigned int>(entry.col()));
      sort_once(columns);
      return columns;
    }

    // A cell's stiffness as one of the vertices from which its nodes are interpolated.
    class GalerkinCell
    {
    public:
      explicit GalerkinCell(const Interpolation &interpolation)
        : interpolation_(interpolation)
      {
      }

      // WᵀKW with K of n × n blocks of 3 × 3 numbers and W of n rows, of whose entries
      // few are not zero.
      //
      // vertices: those touched_by() the n nodes.
      const BlockMatrix::Entries &operator()(const std::vector<unsigned int> &nodes,
                                             const std::vector<unsigned int> &vertices,
                                             const FullMatrix<double> &K)
      {
        entries_.vertices = vertices;
        const auto m      = static_cast<Eigen::Index>(entries_.vertices.size());
        const auto n      = static_cast<unsigned int>(nodes.size());
        Eigen::VectorXd row(9 * n);
        half_.setZero(9 * n, m);
        weights_.resize(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            weights_[i].clear();
            for (Interpolation::InnerIterator entry(interpolation_, nodes[i]); entry;
                 ++entry)
              weights_[i].emplace_back(place_in(vertices, entry.col()), entry.value());
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int a = 0; a < 3; ++a)
                for (unsigned int b = 0; b < 3; ++b)
                  row(9 * j + 3 * a + b) = K(3 * i + a, 3 * j + b);
            for (const auto &[vertex, weight] : weights_[i])
              half_.col(vertex) += weight * row;
          }
        entries_.blocks.setZero(9 * m, m);
        for (unsigned int j = 0; j < n; ++j)
          {
            const Eigen::Matrix<double, 9, Eigen::Dynamic> of_node =
              half_.middleRows<9>(9 * j);
            for (const auto &[vertex, weight] : weights_[j])
              {
                const Eigen::Index length = 9 * (m - vertex);
                entries_.blocks.col(vertex).tail(length) +=
                  weight * Eigen::Map<const Eigen::VectorXd>(&of_node(0, vertex), length);
              }
          }
        return entries_;
      }

    private:
      const Interpolation &interpolation_;
      BlockMatrix::Entries entries_;
      std::vector<std::vector<std::pair<Eigen::Index, double>>> weights_; // of each node
      Eigen::MatrixXd half_;
    };

    void drop_fixed(FullMatrix<double> &K, const std::vector<unsigned int> &nodes,
                    const LA::Vector &fixed)
    {
      for (unsigned int k = 0; k < K.m(); ++k)
        if (fixed.local_element(3 * nodes[k / 3] + k % 3) != 0.)
          for (unsigned int j = 0; j < K.m(); ++j)
            K(k, j) = K(j, k) = 0.;
    }

    // A hanging node follows from the nodes it depends on, and is prescribed as far as
    // all of these are.
    void interpolate_hanging_nodes(const MeshLevel &mesh, Interpolation &interpolation,
                                   LA::Vector &is_fixed)
    {
      const std::vector<MeshLevel::HangingNode> hanging = mesh.hanging_nodes();
      if (hanging.empty())
        return;
      const auto row = [&](const unsigned int node) {
        return static_cast<Eigen::Index>(mesh.first_dof(node) / 3);
      };
      std::set<Eigen::Index> rows;
      std::vector<Eigen::Triplet<float>> entries;
      for (const auto &[node, others] : hanging)
        {
          rows.insert(row(node));
          for (const auto &[other, weight] : others)
            for (Interpolation::InnerIterator entry(interpolation, row(other)); entry;
                 ++entry)
              entries.emplace_back(row(node), entry.col(),
                                   static_cast<float>(weight) * entry.value());
          for (unsigned int c = 0; c < 3; ++c)
            {
              const bool are_fixed =
                std::all_of(others.begin(), others.end(), [&](const auto &other) {
                  return is_fixed.local_element(3 * other.first + c) != 0.;
                });
              is_fixed.local_element(3 * node + c) = are_fixed ? 1. : 0.;
            }
        }
      for (Eigen::Index i = 0; i < interpolation.outerSize(); ++i)
        if (rows.count(i) == 0)
          for (Interpolation::InnerIterator entry(interpolation, i); entry; ++entry)
            entries.emplace_back(i, entry.col(), entry.value());
      interpolation.setFromTriplets(entries.begin(), entries.end());
    }
  } // namespace

  BackgroundMultigrid::BackgroundMultigrid(
    const Materials &materials, const MeshLevel &mesh, const double unit,
    const LA::Vector &fixed, const std::vector<types::global_dof_index> &first_dofs,
    const BasisTransformation &basis)
    : unit_(unit)
    , stiffness_of_supported_(first_dofs.size(), 0.)
    , ground_((basis.ground() / unit).cast<float>())
  {
    std::vector<Interpolation> grids = make_grids(mesh);
    LA::Vector is_left_out           = fixed;
    is_left_out.update_ghost_values();
    interpolate_hanging_nodes(mesh, grids.front(), is_left_out);
    const auto node = [&](const unsigned int local) {
      return static_cast<unsigned int>(mesh.first_dof(local) / 3);
    };
    std::unordered_map<unsigned int, std::size_t> in_list;
    for (std::size_t i = 0; i < first_dofs.size(); ++i)
      in_list[static_cast<unsigned int>(first_dofs[i] / 3)] = i;

    GalerkinCell galerkin(grids.front());
    std::vector<std::vector<unsigned int>> sets;
    for_each_cell(mesh, [&](const std::vector<unsigned int> &nodes) {
      sets.push_back(touched_by(nodes, grids.front()));
    });
    BlockMatrix A(static_cast<std::size_t>(grids.front().cols()), sets);

    FullMatrix<double> K;
    std::size_t n_cells = 0;
    for_each_element(mesh, materials, unit, [&](const auto &cell, const auto &free) {
      K = free;
      std::vector<unsigned int> nodes(cell.size());
      for (unsigned int v = 0; v < nodes.size(); ++v)
        {
          nodes[v] = node(cell[v]);
          if (const auto place = in_list.find(nodes[v]); place != in_list.end())
            for (unsigned int c = 0; c < 3; ++c)
              stiffness_of_supported_[place->second] += K(3 * v + c, 3 * v + c) / 3.;
        }
      drop_fixed(K, cell, is_left_out);
      A.add(galerkin(nodes, sets[n_cells++], K));
    });
    A.end_of_sums();
    Utilities::MPI::sum(stiffness_of_supported_, mesh.communicator(),
                        stiffness_of_supported_);

    to_mesh_ = grids.front().middleRows(
      mesh.n_owned_nodes() > 0 ? static_cast<Eigen::Index>(node(0)) : 0,
      static_cast<Eigen::Index>(mesh.n_owned_nodes()));
    std::vector<unsigned int> with_springs;
    for (const auto *const dofs : {&first_dofs, &basis.masters()})
      for (const auto dof : *dofs)
        with_springs.push_back(static_cast<unsigned int>(dof / 3));
    to_supported_ = rows_of(grids.front(), with_springs);
    std::vector<std::vector<unsigned int>> touched{
      touched_by(with_springs, grids.front())};
    for (std::size_t g = 0; g < grids.size(); ++g)
      {
        if (g > 0)
          {
            A = BlockMatrix(grids_.back()->share(), grids[g]);
            touched.push_back(touched_by(touched.back(), grids[g]));
          }
        grids_.push_back(std::make_unique<Grid>(
          std::move(A), // NOLINT(bugprone-use-after-move): made anew for the next one
          touched.back(), g > 0 ? grids[g] : Interpolation(), g + 1 == grids.size(),
          mesh.communicator()));
      }
    if (!basis.is_identity())
      between_ =
        std::make_unique<SpringsBetweenBodies>(basis, to_supported_, touched, grids);
  }

  BackgroundMultigrid::~BackgroundMultigrid() = default;

  void BackgroundMultigrid::set_supports(const NodalSupports &supports)
  {
    std::vector<Eigen::Matrix3f> finer(to_supported_.rows(), Eigen::Matrix3f::Zero());
    for (std::size_t i = 0; i < supports.size(); ++i)
      finer[i] = (supports[i].spring / unit_ +
                  stiffness_of_supported_[i] *
                    (Eigen::Matrix3d::Identity() - supports[i].projection))
                   .cast<float>();
    std::vector<BlockMatrix> between;
    if (between_)
      {
        between = between_->on_grids(finer);
        for (std::size_t i = 0; i < supports.size(); ++i)
          if (between_->has(i))
            finer[i].setZero();
      }
    for (Eigen::Index j = 0; j < ground_.size(); ++j)
      finer[supports.size() + j] = ground_(j) * Eigen::Matrix3f::Identity();
    const Interpolation *to_finer = &to_supported_;
    std::vector<unsigned int> rows(finer.size());
    std::iota(rows.begin(), rows.end(), 0u);
    for (std::size_t g = 0; g < grids_.size(); ++g)
      {
        Grid &grid                               = *grids_[g];
        const std::vector<unsigned int> &touched = grid.touched();
        Grid::Springs springs(touched.size(), Eigen::Matrix3f::Zero());
        if (g > 0)
          to_finer = &grid.to_finer();
        for (std::size_t i = 0; i < rows.size(); ++i)
          for (Interpolation::InnerIterator entry(*to_finer, rows[i]); entry; ++entry)
            springs[place_in(touched, entry.col())] += entry.value() * finer[i];
        grid.set_springs(springs, between.empty() ? nullptr
                                                  : std::make_unique<BlockMatrix>(
                                                      std::move(between[g])));
        finer = std::move(springs);
        rows  = touched;
      }
  }

  void BackgroundMultigrid::correct(LA::VectorOf<float> &x, const LA::VectorOf<float> &r)
  {
    Grid &first = *grids_.front();
    const Eigen::Map<const BlockVector> residual(r.begin(), to_mesh_.rows(), 3);
    Eigen::Map<BlockVector> corrected(x.begin(), to_mesh_.rows(), 3);
    first.b.noalias() = to_mesh_.transpose() * residual;
    sum_over_ranks(first.b, r.get_mpi_communicator());
    cycle(0);
    corrected.noalias() += to_mesh_ * first.x;
  }

  void BackgroundMultigrid::cycle(const std::size_t grid)
  {
    Grid &fine = *grids_[grid];
    if (grid + 1 == grids_.size())
      return fine.solve();
    Grid &coarse                  = *grids_[grid + 1];
    const Interpolation &transfer = coarse.to_finer();
    fine.smooth_from_zero();
    coarse.b.noalias() = transfer.transpose() * fine.residual();
    cycle(grid + 1);
    fine.x.noalias() += transfer * coarse.x;
    fine.smooth();
  }
} // namespace stiction
