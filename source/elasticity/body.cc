#include <stiction/elasticity/body.h>
#include <stiction/elasticity/coarse_mesh.h>
#include <stiction/errors.h>
#include <stiction/parameters.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace stiction
{
  using namespace dealii;

  Body::Body(const GeometryParameters &geometry,
             MPI_Comm communicator,
             const std::function<void(double n_cells)> &check_size)
    // all cells of a level exist on their owners, which later multigrid needs,
    // and vertices come out the same on any partition
    : triangulation_(
        communicator,
        Triangulation<3>::limit_level_difference_at_vertices,
        parallel::distributed::Triangulation<3>::construct_multigrid_hierarchy)
    , fe_(FE_Q<3>(1), 3)
    , dof_handler_(triangulation_)
  {
    make_grid(geometry, check_size);
    find_bounding_box();
    distribute_dofs();
    collect_nodes();
  }



  void
  Body::make_grid(const GeometryParameters &geometry,
                  const std::function<void(double n_cells)> &check_size)
  {
    if (geometry.is_brick())
      {
        Point<3> corner;
        for (unsigned int d = 0; d < 3; ++d)
          corner[d] = geometry.lengths[d];
        GridGenerator::subdivided_hyper_rectangle(
          triangulation_, geometry.subdivisions, Point<3>(), corner, true);
        boundary_names_ = MeshNames::brick_boundaries();
        material_names_ = MeshNames("material", {0}, {});
        triangulation_.refine_global(geometry.global_refinement);
        return;
      }

    const CoarseMesh coarse(geometry);
    if (check_size)
      check_size(coarse.triangulation().n_active_cells() *
                 std::pow(8., geometry.global_refinement));
    boundary_names_ = coarse.boundary_names();
    material_names_ = coarse.material_names();
    triangulation_.copy_triangulation(coarse.triangulation());
    triangulation_.refine_global(geometry.global_refinement);
    together(communicator(),
             [&]() { require_valid_cells(triangulation_, geometry.location); });
  }



  void
  Body::find_bounding_box()
  {
    // of the coarse cells, which every rank knows, and of those at hand: a
    // curved body grows when it is refined
    auto corners =
      GridTools::compute_bounding_box(triangulation_).get_boundary_points();
    for (unsigned int d = 0; d < 3; ++d)
      {
        corners.first[d] =
          Utilities::MPI::min(corners.first[d], communicator());
        corners.second[d] =
          Utilities::MPI::max(corners.second[d], communicator());
      }
    bounding_box_ = BoundingBox<3>(corners);
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
    material_names_ = MeshNames("material", {ids.begin(), ids.end()}, {});
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
