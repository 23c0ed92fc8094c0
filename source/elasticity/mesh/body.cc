#include <stiction/base/errors.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/geometry_parameters.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The nodes of a cell in the shape that the manifold gives it.
    std::vector<Point<3>> curved_nodes(const Triangulation<3>::cell_iterator &cell,
                                       const FESystem<3> &fe)
    {
      const MappingQ<3> mapping(fe.degree);
      FEValues<3> values(mapping, fe.base_element(0),
                         fe.base_element(0).get_unit_support_points(),
                         update_quadrature_points);
      values.reinit(cell);
      return values.get_quadrature_points();
    }
  } // namespace

  Body::Body(const GeometryParameters &geometry, MPI_Comm communicator,
             const std::function<void(double n_cells)> &check_size)
    // all cells of a level exist on their owners, which later multigrid needs,
    // and vertices come out the same on any partition
    : triangulation_(
        communicator, Triangulation<3>::limit_level_difference_at_vertices,
        parallel::distributed::Triangulation<3>::construct_multigrid_hierarchy)
    , fe_(FE_Q<3>(geometry.element_degree), 3)
    , location_(geometry.location)
    , mapping_(std::make_unique<MappingQ<3>>(geometry.element_degree))
    , dof_handler_(triangulation_)
  {
    make_grid(geometry, check_size);
    distribute_dofs();
    collect_nodes();
    find_bounding_boxes();
    begin_adaptive_refinement();
  }

  void Body::make_grid(const GeometryParameters &geometry,
                       const std::function<void(double n_cells)> &check_size)
  {
    if (geometry.is_brick())
      {
        CoarseMesh::make_brick(geometry, triangulation_);
        origin_.boundary_names = MeshNames::brick_boundaries();
        origin_.material_names = MeshNames("material", {0}, {});
        triangulation_.refine_global(geometry.global_refinement);
        return;
      }

    std::unique_ptr<const CoarseMesh> made;
    throw_on_all_ranks(communicator(), [&]() { // their files may differ
      made = geometry.bodies.empty() ? std::make_unique<CoarseMesh>(geometry)
                                     : std::make_unique<CoarseMesh>(geometry.bodies);
    });
    const CoarseMesh &coarse = *made;
    if (check_size)
      check_size(coarse.triangulation().n_active_cells() *
                 std::pow(8., geometry.global_refinement));
    triangulation_.copy_triangulation(coarse.triangulation());
    origin_              = coarse.origin();
    pieces_              = MeshPieces(triangulation_,
                                      [&](const auto &cell) { return coarse.body_name(cell); });
    const auto manifolds = coarse.triangulation().get_manifold_ids();
    is_curved_           = !origin_.quadratic_cells.empty() ||
                 std::any_of(manifolds.begin(), manifolds.end(), [](const auto id) {
                   return id != numbers::flat_manifold_id;
                 });
    triangulation_.refine_global(geometry.global_refinement);
    shape_cells();
    if (geometry.global_refinement > 0) // the coarse ones are
      throw_on_all_ranks(communicator(), [&]() {
        require_valid_cells(triangulation_, origin_.quadratic_cells, location_);
      });
  }

  void Body::shape_cells()
  {
    if (origin_.quadratic_cells.empty())
      return;
    origin_.quadratic_cells.place_vertices(triangulation_);
    if (fe_.degree == 1)
      return;
    const std::vector<Point<3>> &unit_points =
      fe_.base_element(0).get_unit_support_points();
    auto mapping = std::make_unique<MappingQCache<3>>(fe_.degree);
    mapping->initialize(triangulation_, [&](const Triangulation<3>::cell_iterator &cell) {
      std::vector<Point<3>> points;
      for (const Point<3> &p : unit_points)
        points.push_back(origin_.quadratic_cells.position(cell, p));
      return points;
    });
    mapping_ = std::move(mapping);
  }

  void Body::find_bounding_boxes()
  {
    // nodes may lie outside of the corners of curved cells
    std::vector<std::vector<Point<3>>> points(pieces().size());
    if (fe_.degree > 1)
      for (const Node &node : nodes_)
        points[node.piece].push_back(node.position);
    pieces_.find_boxes(triangulation_, points);
    bounding_box_ = pieces().front().box;
    for (const Piece &piece : pieces())
      bounding_box_.merge_with(piece.box);
  }

  std::vector<std::pair<std::string, std::string>> Body::touching_without(
    const std::vector<std::pair<types::boundary_id, types::boundary_id>> &pairs) const
  {
    std::vector<std::pair<std::string, std::string>> names;
    for (const auto &[p, q] : pieces_.touching(triangulation_))
      if (std::none_of(pairs.begin(), pairs.end(), [&, p = p, q = q](const auto &pair) {
            const auto first  = pieces_at(pair.first);
            const auto second = pieces_at(pair.second);
            return (first.count(p) > 0 && second.count(q) > 0) ||
                   (first.count(q) > 0 && second.count(p) > 0);
          }))
        names.emplace_back(pieces()[p].name, pieces()[q].name);
    return names;
  }

  void Body::set_material_ids(
    const std::function<types::material_id(const Point<3> &)> &id_at)
  {
    std::vector<types::material_id> ids;
    for (const auto &cell : triangulation_.cell_iterators_on_level(0))
      ids.push_back(id_at(cell->center()));
    std::size_t i = 0;
    for (const auto &cell : triangulation_.cell_iterators_on_level(0))
      cell->recursively_set_material_id(ids[i++]);
    origin_.material_names = MeshNames("material", {ids.begin(), ids.end()}, {});
  }

  void Body::refine(const std::vector<bool> &is_cut,
                    const std::vector<LA::Vector *> &fields)
  {
    parallel::distributed::SolutionTransfer<3, LA::Vector> transfer(dof_handler_);
    // a copy of such a vector would lose what is of other ranks
    std::vector<LA::Vector> old_fields(fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i)
      old_fields[i] = with_ghosts(*fields[i]);
    for (const auto &cell : triangulation_.active_cell_iterators())
      if (cell->is_locally_owned() && is_cut[cell->active_cell_index()])
        cell->set_refine_flag();
    if (!fields.empty())
      {
        triangulation_.prepare_coarsening_and_refinement();
        std::vector<const LA::Vector *> all;
        for (const LA::Vector &field : old_fields)
          all.push_back(&field);
        transfer.prepare_for_coarsening_and_refinement(all);
      }
    put_hanging_nodes_back();
    triangulation_.execute_coarsening_and_refinement();
    shape_cells();
    distribute_dofs();
    straighten_hanging_nodes();
    if (is_curved_)
      throw_on_all_ranks(communicator(), [&]() {
        require_valid_cells(triangulation_, origin_.quadratic_cells, location_);
      });
    collect_nodes();
    for (LA::Vector *field : fields)
      field->reinit(locally_owned_dofs(), locally_relevant_dofs_, communicator());
    if (!fields.empty())
      {
        std::vector<LA::Vector *> all = fields;
        transfer.interpolate(all);
      }
  }

  LA::Vector Body::with_ghosts(const LA::Vector &field) const
  {
    LA::Vector ghosted(locally_owned_dofs(), locally_relevant_dofs_, communicator());
    ghosted.copy_locally_owned_data_from(field);
    ghosted.update_ghost_values();
    return ghosted;
  }

  std::vector<std::pair<types::global_dof_index, double>> Body::followed_by(
    const types::global_dof_index dof) const
  {
    if (is_hanging(dof))
      return *hanging_nodes_.get_constraint_entries(dof);
    return {{dof, 1.}};
  }

  void Body::distribute_dofs()
  {
    is_uniform_ = !triangulation_.has_hanging_nodes();
    dof_handler_.distribute_dofs(fe_);
    vertex_dof_handler_.reset();
    if (fe_.degree > 1 && has_levels())
      {
        vertex_dof_handler_ = std::make_unique<DoFHandler<3>>(triangulation_);
        vertex_dof_handler_->distribute_dofs(FESystem<3>(FE_Q<3>(1), 3));
        vertex_dof_handler_->distribute_mg_dofs();
      }
    else if (has_levels() && triangulation_.n_global_levels() > 1)
      dof_handler_.distribute_mg_dofs(); // cheap next to the mesh
    DoFTools::extract_locally_relevant_dofs(dof_handler_, locally_relevant_dofs_);
    hanging_nodes_.reinit(locally_relevant_dofs_);
    if (!is_uniform_)
      DoFTools::make_hanging_node_constraints(dof_handler_, hanging_nodes_);
    hanging_nodes_.close();
  }

  void Body::straighten_hanging_nodes()
  {
    // cells of second order, of the degree of the elements, are alike on both
    // sides of a face
    if (!is_curved_ || (fe_.degree > 1 && !origin_.quadratic_cells.empty()))
      return;
    if (fe_.degree > 1) // a cache knows the cells of the last mesh alone
      mapping_ = std::make_unique<MappingQ<3>>(fe_.degree);
    if (is_uniform_)
      return;
    const auto straight = straight_nodes();
    if (fe_.degree == 1)
      {
        curved_vertices_ = triangulation_.get_vertices();
        for (const auto &cell : triangulation_.active_cell_iterators())
          if (const auto nodes = straight.find(cell->active_cell_index());
              nodes != straight.end())
            for (const unsigned int v : GeometryInfo<3>::vertex_indices())
              cell->vertex(v) = nodes->second[v];
        return;
      }
    auto mapping = std::make_unique<MappingQCache<3>>(fe_.degree);
    mapping->initialize(triangulation_, [&](const Triangulation<3>::cell_iterator &cell) {
      if (cell->is_active())
        if (const auto nodes = straight.find(cell->active_cell_index());
            nodes != straight.end())
          return nodes->second;
      return curved_nodes(cell, fe_);
    });
    mapping_ = std::move(mapping);
  }

  std::map<unsigned int, std::vector<Point<3>>> Body::straight_nodes() const
  {
    using Nodes = std::vector<Point<3>>;
    using Cell  = DoFHandler<3>::active_cell_iterator;
    std::vector<types::global_dof_index> dofs(fe_.n_dofs_per_cell());
    std::map<types::global_dof_index, Point<3>> position; // by first unknowns
    for (const Cell &cell : dof_handler_.active_cell_iterators())
      if (!cell->is_artificial())
        {
          cell->get_dof_indices(dofs);
          const Nodes nodes = curved_nodes(cell, fe_);
          for (unsigned int i = 0; i < nodes.size(); ++i)
            position[dofs[3 * i]] = nodes[i];
        }

    std::map<unsigned int, Nodes> straight;
    for (const Cell &cell : locally_owned_cells())
      {
        cell->get_dof_indices(dofs);
        Nodes nodes = curved_nodes(cell, fe_);
        bool hangs  = false;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          if (is_hanging(dofs[3 * i]))
            {
              hangs    = true;
              nodes[i] = Point<3>();
              for (const auto &[other, weight] :
                   *hanging_nodes_.get_constraint_entries(dofs[3 * i]))
                nodes[i] += weight * position.at(other);
            }
        if (hangs)
          straight[cell->active_cell_index()] = nodes;
      }
    // only its owner knows for sure what hangs on a cell
    GridTools::exchange_cell_data_to_ghosts<Nodes, DoFHandler<3>>(
      dof_handler_,
      [&](const Cell &cell) -> std_cxx17::optional<Nodes> {
        const auto own = straight.find(cell->active_cell_index());
        if (own == straight.end())
          return {};
        return own->second;
      },
      [&](const Cell &cell, const Nodes &nodes) {
        straight[cell->active_cell_index()] = nodes;
      });
    return straight;
  }

  void Body::put_hanging_nodes_back()
  {
    if (curved_vertices_.empty())
      return;
    for (const auto &cell : triangulation_.cell_iterators())
      for (const unsigned int v : GeometryInfo<3>::vertex_indices())
        cell->vertex(v) = curved_vertices_[cell->vertex_index(v)];
    curved_vertices_.clear();
  }

  void Body::collect_nodes()
  {
    // three consecutive unknowns a node, on a cell too; a rank owns a range of
    // them
    const IndexSet &owned = locally_owned_dofs();
    nodes_.resize(owned.n_elements() / 3);
    std::vector<types::global_dof_index> dofs(fe_.n_dofs_per_cell());
    FEValues<3> values(*mapping_, fe_.base_element(0),
                       fe_.base_element(0).get_unit_support_points(),
                       update_quadrature_points);
    for (const auto &cell : locally_owned_cells())
      {
        cell->get_dof_indices(dofs);
        const unsigned int piece = piece_of(cell);
        if (fe_.degree > 1)
          values.reinit(cell);
        for (unsigned int i = 0; i < dofs.size(); i += 3)
          {
            if (!owned.is_element(dofs[i]))
              continue;
            Node &node = nodes_[owned.index_within_set(dofs[i]) / 3];
            std::copy_n(&dofs[i], 3, node.dofs.begin());
            node.piece    = piece;
            node.position = i / 3 < cell->n_vertices() // which come first
                              ? cell->vertex(i / 3)
                              : values.quadrature_point(i / 3);
          }
      }
    types::global_dof_index n_hanging = 0;
    for (const Node &node : nodes_)
      n_hanging += is_hanging(node.dofs[0]) ? 1 : 0;
    n_hanging_nodes_ = Utilities::MPI::sum(n_hanging, communicator());
  }
} // namespace stiction
