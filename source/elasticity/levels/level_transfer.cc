#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/levels/level_transfer.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <limits>
#include <type_traits>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The nodes of a coarse cell after refinement, or of degree 2, 3 × 3 × 3: the child
    // and its vertex where node i is found, and the coarse vertices around it.
    struct FineNode
    {
      unsigned int child, vertex;
      std::vector<unsigned int> coarse_vertices;
    };

    std::vector<FineNode> fine_nodes_of_a_cell()
    {
      std::vector<FineNode> nodes(27);
      for (unsigned int i = 0; i < 27; ++i)
        {
          FineNode &node                       = nodes[i];
          const std::array<unsigned int, 3> at = {{i % 3, i / 3 % 3, i / 9}};
          for (unsigned int d = 0; d < 3; ++d)
            {
              const unsigned int child = at[d] == 2 ? 1 : 0;
              node.child += child << d;
              node.vertex += (at[d] - child) << d;
            }
          for (unsigned int v = 0; v < 8; ++v)
            {
              bool is_near = true;
              for (unsigned int d = 0; d < 3; ++d)
                is_near = is_near && (at[d] == 1 || at[d] / 2 == (v >> d & 1));
              if (is_near)
                node.coarse_vertices.push_back(v);
            }
        }
      return nodes;
    }

    // How many coarse nodes the rows of a list have.
    template<typename Rows>
    constexpr std::size_t n_coarse =
      std::tuple_size<typename std::decay_t<Rows>::value_type>() - 1;

    template<typename Lists, typename Visit>
    void for_each_list(Lists &lists, const Visit &visit)
    {
      std::apply([&](auto &...list) { (visit(list), ...); }, lists);
    }

    // fine += P coarse
    template<typename Rows, typename Number>
    void gather(const Rows &rows, Number *fine, const Number *coarse)
    {
      constexpr std::size_t n = n_coarse<Rows>;
      constexpr Number weight = Number(1.) / n;
      for (const auto &row : rows)
        {
          Number sum[3] = {};
          for (std::size_t k = 1; k <= n; ++k)
            for (unsigned int c = 0; c < 3; ++c)
              sum[c] += coarse[3 * std::size_t(row[k]) + c];
          for (unsigned int c = 0; c < 3; ++c)
            fine[3 * std::size_t(row[0]) + c] += weight * sum[c];
        }
    }

    template<typename Rows, typename Number>
    void scatter(const Rows &rows, Number *coarse, const Number *fine)
    {
      constexpr std::size_t n = n_coarse<Rows>;
      constexpr Number weight = Number(1.) / n;
      for (const auto &row : rows)
        {
          Number share[3];
          for (unsigned int c = 0; c < 3; ++c)
            share[c] = weight * fine[3 * std::size_t(row[0]) + c];
          for (std::size_t k = 1; k <= n; ++k)
            for (unsigned int c = 0; c < 3; ++c)
              coarse[3 * std::size_t(row[k]) + c] += share[c];
        }
    }
  } // namespace

  LevelTransfer::LevelTransfer(const Body &body, const unsigned int fine_level,
                               const MeshLevel &coarse, const MeshLevel &fine)
  {
    const DoFHandler<3> &coarse_dofs = body.vertex_dof_handler();
    const auto nodes                 = fine_nodes_of_a_cell();
    const unsigned int rank = Utilities::MPI::this_mpi_process(body.communicator());

    // visit(coarse cell, what is its node, the local number of that)
    const auto for_each_node = [&](const auto &visit) {
      if (fine.is_trilinear())
        {
          for (const auto &cell : coarse_dofs.mg_cell_iterators_on_level(fine_level - 1))
            if (cell->is_locally_owned_on_level() && cell->has_children())
              for (const FineNode &node : nodes)
                visit(cell, node,
                      fine.local_node(cell->child(node.child)
                                        ->mg_vertex_dof_index(
                                          static_cast<int>(fine_level), node.vertex, 0)));
          return;
        }
      const auto in_cell = FETools::lexicographic_to_hierarchic_numbering<3>(2);
      std::vector<types::global_dof_index> dofs(3 * in_cell.size());
      for (const auto &cell : body.locally_owned_cells())
        {
          cell->get_dof_indices(dofs);
          const DoFHandler<3>::level_cell_iterator same(
            &body.triangulation(), cell->level(), cell->index(), &coarse_dofs);
          for (unsigned int i = 0; i < 27; ++i)
            visit(same, nodes[i], fine.local_node(dofs[3 * in_cell[i]]));
        }
    };

    // Several ranks see a fine node between their coarse cells: the first of
    // them interpolates to it.
    std::vector<bool> is_mine(fine.n_local_nodes(), true);
    if (Utilities::MPI::n_mpi_processes(body.communicator()) > 1)
      {
        auto first_rank = fine.zero_vector<double>();
        for (unsigned int i = 0; i < 3 * fine.n_local_nodes(); ++i)
          first_rank.local_element(i) = std::numeric_limits<double>::max();
        for_each_node([&](const auto &, const FineNode &, const unsigned int i) {
          first_rank.local_element(3 * i) = rank;
        });
        first_rank.compress(VectorOperation::min);
        first_rank.update_ghost_values();
        for (unsigned int i = 0; i < fine.n_local_nodes(); ++i)
          is_mine[i] = first_rank.local_element(3 * i) == rank;
      }

    for_each_node([&](const auto &cell, const FineNode &node, const unsigned int i) {
      if (!is_mine[i])
        return;
      is_mine[i] = false; // only once
      for_each_list(rows_, [&](auto &rows) {
        if (n_coarse<decltype(rows)> == node.coarse_vertices.size())
          {
            auto &row = rows.emplace_back();
            row[0]    = i;
            for (unsigned int k = 1; k < row.size(); ++k)
              row[k] = coarse.local_node(cell->mg_vertex_dof_index(
                fine_level - 1, node.coarse_vertices[k - 1], 0));
          }
      });
    });
  }

  void LevelTransfer::prolongate(LA::Vector &fine, const LA::Vector &coarse) const
  {
    fine = 0.;
    prolongate_add(fine, coarse);
  }

  template<typename Number>
  void LevelTransfer::prolongate_add(LA::VectorOf<Number> &fine,
                                     const LA::VectorOf<Number> &coarse) const
  {
    // the ghosts of the fine vector are zero, and take what goes to others
    coarse.update_ghost_values();
    for_each_list(rows_,
                  [&](const auto &rows) { gather(rows, fine.begin(), coarse.begin()); });
    coarse.zero_out_ghost_values();
    fine.compress(VectorOperation::add);
  }

  template<typename Number>
  void LevelTransfer::restrict_to(LA::VectorOf<Number> &coarse,
                                  const LA::VectorOf<Number> &fine) const
  {
    fine.update_ghost_values();
    coarse = Number(0.);
    for_each_list(rows_,
                  [&](const auto &rows) { scatter(rows, coarse.begin(), fine.begin()); });
    fine.zero_out_ghost_values();
    coarse.compress(VectorOperation::add);
  }

  void LevelTransfer::inject(LA::Vector &coarse, const LA::Vector &fine) const
  {
    fine.update_ghost_values();
    coarse = 0.;
    scatter(std::get<Rows<1>>(rows_), coarse.begin(), fine.begin());
    fine.zero_out_ghost_values();
    coarse.compress(VectorOperation::add);
  }

  void LevelTransfer::for_each_row(
    const std::function<void(unsigned int, const unsigned int *, unsigned int)> &callback)
    const
  {
    for_each_list(rows_, [&](const auto &rows) {
      for (const auto &row : rows)
        callback(row[0], &row[1], static_cast<unsigned int>(row.size() - 1));
    });
  }

  template void LevelTransfer::prolongate_add(LA::VectorOf<float> &,
                                              const LA::VectorOf<float> &) const;
  template void LevelTransfer::restrict_to(LA::VectorOf<float> &,
                                           const LA::VectorOf<float> &) const;
  template void LevelTransfer::restrict_to(LA::VectorOf<double> &,
                                           const LA::VectorOf<double> &) const;
} // namespace stiction
