#include <stiction/elasticity/body.h>
#include <stiction/parameters.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

namespace stiction
{
  using namespace dealii;

  Body::Body(const GeometryParameters &geometry, MPI_Comm communicator)
    // all cells of a level exist on their owners, which later multigrid needs,
    // and vertices come out the same on any partition
    : triangulation_(
        communicator,
        Triangulation<3>::limit_level_difference_at_vertices,
        parallel::distributed::Triangulation<3>::construct_multigrid_hierarchy)
    , fe_(FE_Q<3>(1), 3)
    , dof_handler_(triangulation_)
  {
    make_grid(geometry);
    distribute_dofs();
    collect_nodes();
  }



  void
  Body::make_grid(const GeometryParameters &geometry)
  {
    Point<3> corner;
    for (unsigned int d = 0; d < 3; ++d)
      corner[d] = geometry.lengths[d];
    GridGenerator::subdivided_hyper_rectangle(
      triangulation_, geometry.subdivisions, Point<3>(), corner, true);
    boundary_names_ = BoundaryNames::brick();
    // deal.II colours the octants, too
    for (const auto &cell : triangulation_.active_cell_iterators())
      cell->set_material_id(0);
    material_names_ = BoundaryNames({0}, {});

    // the coarse mesh is known to every rank, so this needs no communication
    bounding_box_ = GridTools::compute_bounding_box(triangulation_);

    triangulation_.refine_global(geometry.global_refinement);
  }



  void
  Body::set_material_ids(
    const std::function<types::material_id(const Point<3> &)> &id_at)
  {
    std::vector<types::material_id> ids;
    for (const auto &cell : triangulation_.cell_iterators_on_level(0))
      ids.push_back(id_at(cell->center()));
    std::size_t i = 0;
    for (const auto &cell : triangulation_.cell_iterators_on_level(0))
      cell->recursively_set_material_id(ids[i++]);
    material_names_ = BoundaryNames({ids.begin(), ids.end()}, {});
  }



  void
  Body::distribute_dofs()
  {
    dof_handler_.distribute_dofs(fe_);
    if (triangulation_.n_global_levels() > 1)
      dof_handler_.distribute_mg_dofs(); // cheap next to the mesh
    DoFTools::extract_locally_relevant_dofs(dof_handler_,
                                            locally_relevant_dofs_);
  }



  void
  Body::collect_nodes()
  {
    // three consecutive unknowns a node, a rank owns a range of them
    const IndexSet &owned = locally_owned_dofs();
    nodes_.resize(owned.n_elements() / 3);
    for (const auto &cell : dof_handler_.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto first = cell->vertex_dof_index(v, 0);
            if (!owned.is_element(first))
              continue;
            Node &node = nodes_[owned.index_within_set(first) / 3];
            for (unsigned int c = 0; c < 3; ++c)
              node.dofs[c] = cell->vertex_dof_index(v, c);
            node.position = cell->vertex(v);
          }
  }
} // namespace stiction
