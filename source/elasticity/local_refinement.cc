#include <stiction/elasticity/body.h>
#include <stiction/elasticity/boundary_functions.h>
#include <stiction/elasticity/local_refinement.h>
#include <stiction/errors.h>
#include <stiction/parameters.h>


#include <set>
#include <string>
#include <vector>

namespace stiction
{
  void
  refine_contact_boundary(Body &body, const Parameters &parameters)
  {
    const std::string where = "Geometry/Contact refinement where";
    const ParsedFunction is_refined(
      parameters.geometry.contact_refinement_where,
      1,
      parameters.source.locate(where));
    if (parameters.geometry.contact_refinement == 0)
      return;
    std::set<dealii::types::boundary_id> contact_boundaries;
    for (const std::string &name :
         split_at_bars(parameters.boundary.contact_boundary))
      contact_boundaries.insert(body.boundary_names().id(
        name,
        parameters.source.locate("Boundary conditions/Contact boundary")));

    for (unsigned int k = 0; k < parameters.geometry.contact_refinement; ++k)
      {
        std::vector<bool> is_cut(body.triangulation().n_active_cells());
        together(body.communicator(), [&]() {
          for (const auto &cell : body.triangulation().active_cell_iterators())
            if (cell->is_locally_owned())
              for (const auto &face : cell->face_iterators())
                if (face->at_boundary() &&
                    contact_boundaries.count(face->boundary_id()) > 0 &&
                    is_refined.value(face->center()) > 0.)
                  is_cut[cell->active_cell_index()] = true;
        });
        body.refine(is_cut);
      }
  }
} // namespace stiction
