#include <stiction/base/errors.h>
#include <stiction/base/log.h>
#include <stiction/base/memory.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/cell_marking.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/simulation/adaptive_refinement.h>
#include <stiction/simulation/parameters/memory_estimates.h>
#include <stiction/simulation/parameters/parameters.h>

#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // A body as slender as 1 : 30,000 that is bent has more strain than this times
    // its displacement over its size.
    constexpr double only_moved = 1e-9;
  } // namespace

  AdaptiveRefinement::AdaptiveRefinement(const Parameters &parameters)
    : parameters_(parameters)
  {
  }

  void AdaptiveRefinement::add_mesh(const LinearElasticity &elasticity,
                                    const ContactSurface &surface,
                                    const bool is_certified, const State &state,
                                    const double strain_energy)
  {
    const Body &body = elasticity.body();
    Mesh mesh{static_cast<double>(body.triangulation().n_global_active_cells()),
              static_cast<double>(body.dof_handler().n_dofs()),
              static_cast<double>(surface.n_nodes()), -1., -1.};
    squares_.reinit(0);
    why_not_estimated_ = "The answer is not certified, no error is estimated.";
    if (is_certified)
      {
        try
          {
            squares_ = estimate_error(elasticity, surface, state);
          }
        catch (const InputError &error)
          {
            why_not_estimated_ =
              std::string("The error of the mesh was not estimated: ") + error.what();
            meshes_.push_back(mesh);
            return;
          }
        double sum = 0.;
        for (const double square : squares_)
          sum += square;
        mesh.error        = std::sqrt(Utilities::MPI::sum(sum, body.communicator()));
        const double norm = std::sqrt(2. * strain_energy);
        // of a body that is only moved strain and error are rounding
        const double rounding =
          only_moved * state.u.linfty_norm() *
          std::sqrt(elasticity.materials().largest_youngs_modulus() * body.diameter());
        mesh.relative_error = norm > rounding ? mesh.error / norm : 0.;
      }
    meshes_.push_back(mesh);
  }

  std::vector<bool> AdaptiveRefinement::cells_to_cut(const LinearElasticity &elasticity,
                                                     const ContactSurface &surface)
  {
    const Body &body = elasticity.body();
    const Mesh &mesh = meshes_.back();
    if (mesh.error < 0.)
      {
        is_finished_ = true;
        remark_      = why_not_estimated_;
        return {};
      }

    std::vector<bool> is_cut =
      mark_largest_cells(squares_, parameters_.refinement.fraction, body.communicator());
    std::array<double, 2> n_cut{}; // cells, and their faces in contact
    for (const auto &cell : body.triangulation().active_cell_iterators())
      if (is_cut[cell->active_cell_index()])
        {
          n_cut[0] += 1.;
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && surface.is_contact_boundary(face->boundary_id()))
              n_cut[1] += 1.;
        }
    for (double &n : n_cut)
      n = Utilities::MPI::sum(n, body.communicator());

    const bool is_last        = meshes_.size() > parameters_.refinement.adaptive_steps;
    const std::string why_not = objection(n_cut[0], n_cut[1], body.communicator());
    remark_ = format("Estimated error: %.3g of the energy norm", mesh.relative_error) +
              (is_last           ? ""
               : why_not.empty() ? format("; %.0f cells are cut", n_cut[0])
                                 : "; " + why_not) +
              ".";
    is_finished_ = is_last || !why_not.empty();
    return is_cut;
  }

  std::string AdaptiveRefinement::objection(const double n_cells_to_cut,
                                            const double n_faces_to_cut,
                                            MPI_Comm communicator) const
  {
    const Mesh &mesh = meshes_.back();
    if (n_cells_to_cut == 0. ||
        mesh.relative_error < parameters_.contact_solver.tolerance)
      return "that is below 'Contact solver/Tolerance', no cell is cut";

    if (mesh.relative_error <= parameters_.refinement.wanted_error)
      return "that is within 'Refinement/Wanted error', no cell is cut";

    const double growth     = 1. + 7. * n_cells_to_cut / mesh.n_cells;
    const double n_unknowns = growth * mesh.n_unknowns;
    if (parameters_.refinement.maximum_unknowns > 0 &&
        n_unknowns > parameters_.refinement.maximum_unknowns)
      return format("the next mesh would have about %.0f unknowns, more than "
                    "'Refinement/Maximum unknowns'",
                    n_unknowns);

    // an isolated face that is cut gets five new nodes, one among others three
    const double n_contact_nodes = mesh.n_contact_nodes + 4. * n_faces_to_cut;
    const double bytes =
      memory_for_mesh(parameters_, growth * mesh.n_cells) +
      memory_for_dual_operator(parameters_, 3. * n_contact_nodes, communicator);
    const double available = available_memory(communicator);
    if (bytes > available || growth * mesh.n_cells > GeometryParameters::max_cells)
      return format("the next mesh would have about %.3g unknowns and need "
                    "%.3g GB of memory, at most %.3g GB are here",
                    n_unknowns, bytes / 1e9, available / 1e9);
    return {};
  }

  MeshError AdaptiveRefinement::mesh_error() const
  {
    const Mesh &mesh = meshes_.back();
    MeshError all;
    if (mesh.error >= 0.)
      {
        all.square  = mesh.error * mesh.error;
        all.n_cells = static_cast<unsigned long long>(mesh.n_cells);
      }
    return all;
  }

  Vector<double> AdaptiveRefinement::indicators() const
  {
    Vector<double> roots(squares_);
    for (double &root : roots)
      root = std::sqrt(root);
    return roots;
  }

  bool AdaptiveRefinement::has_raised_error() const
  {
    return !meshes_.empty() && meshes_.front().error >= 0. &&
           meshes_.back().error >= 0. &&
           meshes_.back().relative_error > meshes_.front().relative_error;
  }

  nlohmann::json AdaptiveRefinement::to_json() const
  {
    using nlohmann::json;
    json meshes = json::array();
    for (const Mesh &mesh : meshes_)
      meshes.push_back(
        {{"cells", static_cast<std::size_t>(mesh.n_cells)},
         {"dofs", static_cast<std::size_t>(mesh.n_unknowns)},
         {"contact_nodes", static_cast<std::size_t>(mesh.n_contact_nodes)},
         {"estimated_error", mesh.error < 0. ? json(nullptr) : json(mesh.error)},
         {"relative_estimated_error",
          mesh.error < 0. ? json(nullptr) : json(mesh.relative_error)}});
    return meshes;
  }
} // namespace stiction
