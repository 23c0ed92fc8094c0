#include <stiction/base/errors.h>
#include <stiction/base/interrupted.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/local_refinement.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/simulation/checkpoint/carried_state.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/solvers/coarser_meshes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace stiction
{
  namespace
  {
    // Whether unknowns of both have the same numbers, on all ranks.
    bool is_same_mesh(const Body &one, const Body &other)
    {
      return dealii::Utilities::MPI::min(
               one.locally_owned_dofs() == other.locally_owned_dofs() ? 1 : 0,
               one.communicator()) == 1;
    }
  } // namespace

  CoarserMeshes::CoarserMeshes(const ContactSolver::Setting &setting)
    : setting_(setting)
  {
  }

  bool CoarserMeshes::are_there(const ContactSolver::Setting &setting)
  {
    const Body &body = setting.elasticity.body();
    return setting.parameters.geometry.contact_refinement > 0 &&
           body.n_first_dofs() == body.dof_handler().n_dofs() &&
           !setting.surface.slides_far() && !setting.parameters.has_locking();
  }

  State CoarserMeshes::find(const State &known, ContactStep &last,
                            const ContactSolver::Observer &observer)
  {
    const Parameters &parameters = setting_.parameters;
    const Body &finest           = setting_.elasticity.body();
    std::optional<CarriedState> carried;

    const auto solve_on = [&](Body &body) {
      LinearElasticity elasticity(body, parameters.of_body());
      elasticity.set_time(setting_.elasticity.time());
      const ContactSurface surface(elasticity, parameters.of_contact());
      elasticity.choose_anchors(surface.first_dofs());
      NewtonMultigrid newton(elasticity, surface, parameters.is_matrix_free(),
                             NewtonMultigrid::for_start());
      State state =
        carried ? carried->on(elasticity, surface) : State{{}, {}, known.distances, {}};
      carried.reset();
      const SolveStatus status = newton.solve(
        state,
        std::max(NewtonMultigrid::coarse_tolerance, parameters.contact_solver.tolerance),
        parameters.contact_solver.maximum_iterations,
        [&](const ContactStep &step) {
          last = step;
          observer(step);
        },
        {}, last);
      add_method(statistics_, newton);
      if (status.interrupted)
        throw Interrupted();
      if (status.converged || last.residual < NewtonMultigrid::worthless)
        carried.emplace(state, elasticity, surface);
      return carried ? carried->fields() : std::vector<LA::Vector *>();
    };
    try
      {
        Body body(parameters.geometry, finest.communicator());
        assign_material_ids(body, parameters.of_body());
        refine_contact_boundary(body, parameters.geometry,
                                parameters.contact.all_boundaries(), parameters.source,
                                [&]() { return solve_on(body); });
        if (!carried || !is_same_mesh(body, finest))
          return {};
        return carried->on(setting_.elasticity, setting_.surface);
      }
    catch (const InputError &)
      {
      } // of contact on a mesh that nobody asked for
    catch (const CircleOfSlaves &)
      {
      }
    return {};
  }
} // namespace stiction
