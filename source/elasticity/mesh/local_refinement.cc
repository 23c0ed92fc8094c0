#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/geometry_parameters.h>
#include <stiction/elasticity/mesh/local_refinement.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <set>
#include <vector>

namespace stiction
{
  void refine_contact_boundary(Body &body, const GeometryParameters &geometry,
                               const std::string &contact_boundary,
                               const ParameterFile &source,
                               const std::function<std::vector<LA::Vector *>()> &fields)
  {
    const std::string where = "Geometry/Contact refinement where";
    const ParsedFunction is_refined(geometry.contact_refinement_where, 1,
                                    source.locate(where));
    if (geometry.contact_refinement == 0)
      return;
    is_refined.require_no_time();
    std::set<dealii::types::boundary_id> contact_boundaries;
    for (const std::string &name : split_at_bars(contact_boundary))
      contact_boundaries.insert(body.boundary_names().id(
        name, source.locate("Boundary conditions/Contact boundary")));

    using Cell           = dealii::Triangulation<3>::active_cell_iterator;
    const auto is_wanted = [&](const Cell &cell, const unsigned int f) {
      const auto face = cell->face(f);
      return face->at_boundary() && contact_boundaries.count(face->boundary_id()) > 0 &&
             is_refined.value(face->center()) > 0.;
    };
    // One layer of cut cells alone would end two small cells below the surface,
    // where the large ones make themselves felt in the pressure.
    const auto is_below_wanted = [&](const Cell &cell, const unsigned int f) {
      if (cell->at_boundary(f) || cell->face(f)->has_children() ||
          cell->neighbor_is_coarser(f))
        return false;
      return is_wanted(
        cell->neighbor(f),
        dealii::GeometryInfo<3>::opposite_face[cell->neighbor_of_neighbor(f)]);
    };
    for (unsigned int k = 0; k < geometry.contact_refinement; ++k)
      {
        std::vector<bool> is_cut(body.triangulation().n_active_cells());
        bool is_any = false;
        throw_on_all_ranks(body.communicator(), [&]() {
          for (const auto &cell : body.triangulation().active_cell_iterators())
            if (cell->is_locally_owned())
              for (const unsigned int f : cell->face_indices())
                if (is_wanted(cell, f) || is_below_wanted(cell, f))
                  is_any = is_cut[cell->active_cell_index()] = true;
        });
        source.require(
          k > 0 || dealii::Utilities::MPI::logical_or(is_any, body.communicator()), where,
          "is above 0 at the centre of no face of a contact boundary, must be at one: "
          "faces may be larger than what it speaks of, 'Geometry/Global refinement' "
          "makes them smaller");
        body.refine(is_cut, fields ? fields() : std::vector<LA::Vector *>());
      }
    body.begin_adaptive_refinement();
  }
} // namespace stiction
