#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/node_order.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <mpi.h>
#include <utility>

namespace stiction
{
  using dealii::types::global_dof_index;

  namespace
  {
    using Cell = dealii::DoFHandler<3>::active_cell_iterator;

    // The active cells of this rank along p4est's curve, which ids of cells follow:
    // they begin with the number of p4est's tree.
    std::vector<Cell> cells_in_order(const Body &body)
    {
      std::vector<std::pair<dealii::CellId, Cell>> cells;
      for (const auto &cell : body.locally_owned_cells())
        cells.emplace_back(cell->id(), cell);
      std::sort(cells.begin(), cells.end(),
                [](const auto &a, const auto &b) { return a.first < b.first; });
      std::vector<Cell> in_order;
      for (const auto &cell : cells)
        in_order.push_back(cell.second);
      return in_order;
    }
  } // namespace

  NodeOrder::NodeOrder(const Body &body)
    : body_(body)
  {
    const dealii::IndexSet &owned = body.locally_owned_dofs();
    std::vector<bool> is_met(owned.n_elements(), false);
    std::vector<global_dof_index> dofs(body.dof_handler().get_fe().n_dofs_per_cell());
    for (const Cell &cell : cells_in_order(body))
      {
        cell->get_dof_indices(dofs);
        for (std::size_t i = 0; i < dofs.size(); i += 3) // three a node
          if (owned.is_element(dofs[i]) && !is_met[owned.index_within_set(dofs[i])])
            {
              is_met[owned.index_within_set(dofs[i])] = true;
              first_dofs_.push_back(dofs[i]);
            }
      }
    const std::uint64_t n = first_dofs_.size();
    MPI_Exscan(&n, &first_, 1, MPI_UINT64_T, MPI_SUM, body.communicator());
    if (dealii::Utilities::MPI::this_mpi_process(body.communicator()) == 0)
      first_ = 0; // which MPI leaves undefined
  }

  std::vector<std::uint64_t> NodeOrder::places_of(
    const std::vector<global_dof_index> &nodes) const
  {
    const dealii::IndexSet &owned = body_.locally_owned_dofs();
    std::vector<std::uint64_t> place(owned.n_elements());
    for (std::size_t k = 0; k < first_dofs_.size(); ++k)
      place[owned.index_within_set(first_dofs_[k])] = first_ + k;
    std::vector<std::uint64_t> places(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (owned.is_element(nodes[i]))
        places[i] = place[owned.index_within_set(nodes[i])];
    dealii::Utilities::MPI::sum(places, body_.communicator(), places); // one knows it
    return places;
  }

  std::vector<global_dof_index> NodeOrder::nodes_at(
    const std::vector<std::uint64_t> &places) const
  {
    std::vector<global_dof_index> nodes(places.size(), 0);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i] >= first_ && places[i] - first_ < first_dofs_.size())
        nodes[i] = first_dofs_[places[i] - first_];
    dealii::Utilities::MPI::sum(nodes, body_.communicator(), nodes);
    return nodes;
  }
} // namespace stiction
