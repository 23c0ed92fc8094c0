#include <stiction/elasticity/linear_algebra/nested_dissection.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <metis.h>
#include <numeric>

namespace stiction
{
  namespace
  {
    constexpr int size = 3; // unknowns of a node

    using Edge  = std::array<int, 2>;
    using Edges = std::vector<Edge>;

    // The edges of the graph of the nodes, all of them on rank 0.
    Edges gather_node_graph(const std::vector<int> &rows, const std::vector<int> &columns,
                            MPI_Comm communicator)
    {
      Edges mine;
      for (std::size_t k = 0; k < rows.size(); ++k)
        {
          const Edge edge{{(rows[k] - 1) / size, (columns[k] - 1) / size}};
          if (edge[0] != edge[1] && (mine.empty() || mine.back() != edge))
            mine.push_back(edge);
        }
      sort_once(mine);

      Edges all;
      for (const Edges &theirs : dealii::Utilities::MPI::gather(communicator, mine, 0))
        for (const Edge &edge : theirs)
          {
            all.push_back(edge);
            all.push_back({{edge[1], edge[0]}});
          }
      sort_once(all);
      return all;
    }

    // METIS' order of a graph: which vertex is eliminated as the k-th.
    std::vector<int> dissect(const Edges &edges, const std::size_t n_vertices)
    {
      auto n = static_cast<idx_t>(n_vertices);
      std::vector<idx_t> begin_of(n_vertices + 1, 0), neighbours;
      for (const Edge &edge : edges)
        {
          ++begin_of[edge[0] + 1];
          neighbours.push_back(edge[1]);
        }
      std::partial_sum(begin_of.begin(), begin_of.end(), begin_of.begin());

      std::vector<idx_t> order(n_vertices), position(n_vertices);
      std::iota(order.begin(), order.end(), 0);
      if (!edges.empty())
        {
          idx_t options[METIS_NOPTIONS];
          METIS_SetDefaultOptions(options);
          options[METIS_OPTION_COMPRESS] = 0; // nodes are compressed already
          options[METIS_OPTION_SEED]     = 7; // the same order in every run
          METIS_NodeND(&n, begin_of.data(), neighbours.data(), nullptr, options,
                       order.data(), position.data());
        }
      return {order.begin(), order.end()};
    }
  } // namespace

  std::vector<int> nested_dissection(const std::vector<int> &rows,
                                     const std::vector<int> &columns, const int n,
                                     const std::vector<int> &last, MPI_Comm communicator)
  {
    const Edges edges = gather_node_graph(rows, columns, communicator);
    if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
      return {};

    // the nodes with something to eliminate, and the graph of these
    std::vector<bool> is_last(n, false);
    for (const int dof : last)
      is_last[dof - 1] = true;
    std::vector<int> vertex_of(n / size + 1, -1), nodes;
    for (int dof = 0; dof < n; ++dof)
      if (!is_last[dof] && vertex_of[dof / size] < 0)
        {
          vertex_of[dof / size] = static_cast<int>(nodes.size());
          nodes.push_back(dof / size);
        }
    Edges kept;
    for (const Edge &edge : edges)
      if (vertex_of[edge[0]] >= 0 && vertex_of[edge[1]] >= 0)
        kept.push_back({{vertex_of[edge[0]], vertex_of[edge[1]]}});
    std::sort(kept.begin(), kept.end());

    std::vector<int> position(n);
    int count = 0;
    for (const int vertex : dissect(kept, nodes.size()))
      for (int dof = nodes[vertex] * size; dof < std::min(n, (nodes[vertex] + 1) * size);
           ++dof)
        if (!is_last[dof])
          position[dof] = ++count;
    for (const int dof : last)
      position[dof - 1] = ++count;
    return position;
  }
} // namespace stiction
