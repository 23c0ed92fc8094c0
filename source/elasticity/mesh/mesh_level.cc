#include <stiction/elasticity/kernels/cell_stiffness.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <set>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The first unknowns of the vertices, in the numbering of the mesh or in
    // that of its level.
    template<typename Cell>
    std::array<types::global_dof_index, 8> first_dofs(const Cell &cell,
                                                      const bool is_active)
    {
      std::array<types::global_dof_index, 8> dofs;
      for (unsigned int v = 0; v < 8; ++v)
        dofs[v] = is_active ? cell->vertex_dof_index(v, 0)
                            : cell->mg_vertex_dof_index(cell->level(), v, 0);
      return dofs;
    }

    // The rank of the first child owns the parent: it interpolates from the
    // parent to all children, whoever owns those.
    template<typename Cell> bool is_first_child(const Cell &cell)
    {
      return cell->level() > 0 && cell->parent()->child_index(0) == cell->index();
    }
  } // namespace

  template<typename Callback>
  void MeshLevel::for_each_own_cell(const Callback &callback) const
  {
    if (is_active_)
      {
        for (const auto &cell : dof_handler_.active_cell_iterators())
          if (cell->is_locally_owned())
            callback(cell);
      }
    else
      for (const auto &cell : dof_handler_.mg_cell_iterators_on_level(level_))
        if (cell->is_locally_owned_on_level())
          callback(cell);
  }

  MeshLevel::MeshLevel(const Body &body)
    : body_(body)
    , is_active_(true)
    , level_(0)
    , dof_handler_(body.dof_handler())
  {
    make_partitioner();
  }

  MeshLevel::MeshLevel(const Body &body, const unsigned int level)
    : body_(body)
    , is_active_(false)
    , level_(level)
    , dof_handler_(body.vertex_dof_handler())
  {
    make_partitioner();
  }

  void MeshLevel::make_partitioner()
  {
    const IndexSet &owned = is_active_ ? dof_handler_.locally_owned_dofs()
                                       : dof_handler_.locally_owned_mg_dofs(level_);
    std::vector<types::global_dof_index> ghosts;
    const auto add = [&](const auto &cell) {
      for (const auto dof : first_dofs(cell, is_active_))
        if (!owned.is_element(dof))
          for (unsigned int c = 0; c < 3; ++c)
            ghosts.push_back(dof + c);
    };
    const auto add_with_siblings = [&](const auto &cell) {
      add(cell);
      if (is_first_child(cell))
        for (unsigned int child = 1; child < 8; ++child)
          {
            const auto sibling = cell->parent()->child(child);
            if (!is_active_ || sibling->is_active())
              add(sibling);
          }
    };
    if (is_active_ && (!body_.has_levels() || !is_trilinear()))
      {
        // hanging nodes reach across cells, and nodes lie inside of their edges
        IndexSet others = body_.locally_relevant_dofs();
        others.subtract_set(owned);
        others.fill_index_vector(ghosts);
      }
    else if (Utilities::MPI::n_mpi_processes(body_.communicator()) > 1)
      for_each_own_cell(add_with_siblings);

    sort_once(ghosts);
    IndexSet ghost_set(owned.size());
    ghost_set.add_indices(ghosts.begin(), ghosts.end());
    partitioner_ = std::make_shared<const Utilities::MPI::Partitioner>(
      owned, ghost_set, body_.communicator());
  }

  bool MeshLevel::is_trilinear() const { return dof_handler_.get_fe().degree == 1; }

  MPI_Comm MeshLevel::communicator() const { return body_.communicator(); }

  unsigned int MeshLevel::n_owned_nodes() const
  {
    return partitioner_->locally_owned_size() / 3;
  }

  unsigned int MeshLevel::n_local_nodes() const
  {
    return n_owned_nodes() + partitioner_->n_ghost_indices() / 3;
  }

  std::vector<Point<3>> MeshLevel::node_positions() const
  {
    std::vector<Point<3>> positions;
    if (is_active_)
      for (const Body::Node &node : body_.locally_owned_nodes())
        positions.push_back(node.position);
    positions.resize(n_owned_nodes());
    if (!is_active_)
      for_each_cell([&](const HexahedralCell &cell) {
        for (unsigned int v = 0; v < 8; ++v)
          if (cell.nodes[v] < positions.size())
            for (unsigned int c = 0; c < 3; ++c)
              positions[cell.nodes[v]][c] = cell.vertices[v][c];
      });
    return positions;
  }

  types::global_dof_index MeshLevel::n_dofs() const { return partitioner_->size(); }

  unsigned int MeshLevel::local_node(const types::global_dof_index first_dof) const
  {
    return partitioner_->global_to_local(first_dof) / 3;
  }

  types::global_dof_index MeshLevel::first_dof(const unsigned int local_node) const
  {
    return partitioner_->local_to_global(3 * local_node);
  }

  std::vector<MeshLevel::HangingNode> MeshLevel::hanging_nodes() const
  {
    std::vector<HangingNode> nodes;
    if (!is_active_ || body_.n_hanging_nodes() == 0)
      return nodes;
    std::set<unsigned int> known;
    for_each_node_list([&](const std::vector<unsigned int> &of_cell) {
      for (const unsigned int node : of_cell)
        if (body_.is_hanging(first_dof(node)) && known.insert(node).second)
          {
            nodes.push_back({node, {}});
            for (const auto &[other, weight] :
                 *body_.hanging_nodes().get_constraint_entries(first_dof(node)))
              nodes.back().others.emplace_back(local_node(other), weight);
          }
    });
    return nodes;
  }

  void MeshLevel::for_each_node_list(
    const std::function<void(const std::vector<unsigned int> &)> &callback) const
  {
    if (is_trilinear())
      return for_each_cell([&](const HexahedralCell &cell) {
        callback({cell.nodes.begin(), cell.nodes.end()});
      });
    const auto &fe   = dof_handler_.get_fe();
    const auto order = FETools::lexicographic_to_hierarchic_numbering<3>(fe.degree);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<unsigned int> nodes(order.size());
    for (const auto &cell : dof_handler_.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (std::size_t i = 0; i < nodes.size(); ++i)
            nodes[i] = local_node(dofs[3 * order[i]]);
          callback(nodes);
        }
  }

  template<typename Number> LA::VectorOf<Number> MeshLevel::zero_vector() const
  {
    return LA::VectorOf<Number>(partitioner_);
  }

  template LA::VectorOf<float> MeshLevel::zero_vector<float>() const;
  template LA::VectorOf<double> MeshLevel::zero_vector<double>() const;

  void MeshLevel::for_each_cell(
    const std::function<void(const HexahedralCell &)> &callback) const
  {
    HexahedralCell hexahedron{};
    for_each_own_cell([&](const auto &cell) {
      const auto dofs = first_dofs(cell, is_active_);
      for (unsigned int v = 0; v < 8; ++v)
        {
          hexahedron.nodes[v] = local_node(dofs[v]);
          for (unsigned int d = 0; d < 3; ++d)
            hexahedron.vertices[v][d] = cell->vertex(v)[d];
        }
      hexahedron.material_id = cell->material_id();
      callback(hexahedron);
    });
  }
} // namespace stiction
