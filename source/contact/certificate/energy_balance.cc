#include <stiction/contact/certificate/energy_balance.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace stiction
{
  namespace
  {
    // Of a body that rests all terms are what rounding leaves, 1e-10 of its energy at
    // most; a history of 100,000 steps has larger ones.
    constexpr double least_part = 1e-6;

    // Of the forces of a body: more is out of balance by loads that it has no longer. A
    // tolerance above this leaves as much, which then counts as loads.
    constexpr double out_of_balance = 1e-5;

    // Of the largest change of the displacement: less is rounding.
    constexpr double at_rest = 1e-12;

    double lacking(const EnergyBalance::Step &step)
    {
      return step.loads + step.supports + step.obstacles - step.elastic_change -
             step.dissipation - step.time_stepping;
    }

    // Whether prescribed displacements change by this. Collective.
    bool do_supports_move(const LinearElasticity &elasticity, const LA::Vector &moved)
    {
      double largest = 0.;
      for (const auto dof : elasticity.body().locally_owned_dofs())
        if (elasticity.is_prescribed(dof))
          largest = std::max(largest, std::abs(moved(dof)));
      return dealii::Utilities::MPI::max(largest, elasticity.body().communicator()) >
             at_rest * moved.linfty_norm();
    }

    // One number a node along its normal.
    Eigen::VectorXd along_normals(const ContactSurface &surface, const Eigen::VectorXd &v)
    {
      return by_nodes(v.size(), [&](const Eigen::Index i) {
        return surface.nodes()[i].force_to_cartesian({v(i), 0., 0.});
      });
    }
  } // namespace

  EnergyBalance::Step &EnergyBalance::Step::operator+=(const Step &other)
  {
    loads += other.loads;
    supports += other.supports;
    obstacles += other.obstacles;
    elastic_change += other.elastic_change;
    dissipation += other.dissipation;
    time_stepping += other.time_stepping;
    elastic_energy = other.elastic_energy;
    error.reset();
    return *this;
  }

  EnergyBalance::EnergyBalance(const LinearElasticity &elasticity,
                               const ContactSurface &surface)
  {
    const LA::Vector zero         = elasticity.zero_vector();
    const Eigen::VectorXd nowhere = Eigen::VectorXd::Zero(3 * surface.n_nodes());
    const Eigen::VectorXd ways    = surface.ways_at_start();
    last_ = {zero, zero, zero,    zero,    surface.first_dofs(),       nowhere,
             ways, ways, nowhere, nowhere, surface.approach_at_start()};
  }

  EnergyBalance::EnergyBalance(const LinearElasticity &elasticity,
                               const ContactSurface &surface, const State &state,
                               const std::optional<double> energy_before)
    : last_(end_of(elasticity, surface, state))
    , elastic_energy_(energy_before.value_or(0.5 * (last_.u * last_.internal_force)))
    , is_carried_(energy_before.has_value())
  {
    if (is_carried_)
      {
        // interpolated to new nodes it is not what is prescribed there
        for (const auto dof : elasticity.body().locally_owned_dofs())
          if (elasticity.is_prescribed(dof))
            last_.u(dof) = elasticity.prescribed_value(dof);
        return;
      }

    // After a restart loads and supports may be others. Those before it balanced K u and
    // the contact forces; they count as loads where no support is now, else as reactions.
    LA::Vector missing = last_.internal_force;
    surface.add_forces(1., state.lambda, missing);
    missing.add(-1., last_.load, -1., last_.reaction);
    if (missing.l1_norm() > out_of_balance * last_.internal_force.l1_norm())
      last_.load += missing;
  }

  EnergyBalance::End EnergyBalance::end_of(const LinearElasticity &elasticity,
                                           const ContactSurface &surface,
                                           const State &state)
  {
    End end{state.u,
            elasticity.internal_force(state.u),
            elasticity.load(),
            elasticity.zero_vector(),
            surface.first_dofs(),
            surface.forces(state.lambda)};
    LA::Vector applied = end.load;
    surface.add_forces(-1., state.lambda, applied);
    for (const auto dof : elasticity.body().locally_owned_dofs())
      if (elasticity.is_prescribed(dof))
        end.reaction(dof) = end.internal_force(dof) - applied(dof);

    end.offset =
      surface.obstacle_displacements(state.distances) + surface.ways_at_start();
    end.gap = along_normals(surface, surface.gap_and_slip(state).head(surface.n_nodes()));
    end.arm = by_nodes(surface.n_nodes(), [&](const Eigen::Index i) {
      return to_vector(surface.nodes()[i].arm);
    });
    end.sliding  = end.offset - surface.B().relative_displacement(state.u) - end.gap;
    end.approach = surface.slip_origin(state) - surface.relative_displacement(state);
    return end;
  }

  void EnergyBalance::add_contact(Step &step, const End &before, const End &after,
                                  const ContactSurface &surface, const State &state)
  {
    std::map<dealii::types::global_dof_index, Eigen::Index> index_before;
    for (std::size_t k = 0; k < before.nodes.size(); ++k)
      index_before[before.nodes[k]] = static_cast<Eigen::Index>(k);
    const Eigen::VectorXd r      = surface.gap_and_slip(state);
    const DofSubset nodes_before = DofSubset::of_nodes(before.nodes);
    const Eigen::VectorXd moved  = surface.B().relative_displacement(after.u) -
                                  surface.B().relative_displacement(before.u);
    const Eigen::VectorXd moved_before =
      nodes_before.restriction(after.u) - nodes_before.restriction(before.u);

    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node     = surface.nodes()[i];
        const Eigen::Vector3d force = at_node(after.force, i);
        Eigen::Vector3d slip        = -at_node(r, i);
        slip(0)                     = 0.;
        slip                        = node.displacement_to_cartesian(slip);
        step.dissipation += force.dot(slip);
        const auto place = index_before.find(after.nodes[i]);
        if (place == index_before.end())
          {
            step.time_stepping += force.dot(0.5 * at_node(moved, i)) - force.dot(slip);
            continue;
          }
        const Eigen::Vector3d turning = to_vector(node.turning);
        const Eigen::Index k          = place->second;
        // forces at the beginning turn with the arms that they had there
        const double turned_before =
          at_node(before.force, k)
            .dot(surface.turned(node) * at_node(before.arm, k) - turning);
        step.obstacles -= 0.5 * turned_before;
        step.time_stepping -= 0.5 * turned_before;
        const Eigen::Vector3d force_before = at_node(before.force, k);
        const Eigen::Vector3d sum          = force_before + force;
        step.obstacles -=
          0.5 * sum.dot(at_node(after.offset, i) + turning - at_node(before.offset, k) -
                        at_node(before.approach, k));
        // of the way along the obstacle, what frames leave out as they turn
        const Eigen::Vector3d turned = at_node(after.sliding, i) + turning -
                                       at_node(before.sliding, k) -
                                       at_node(before.approach, k) + slip;
        step.time_stepping +=
          0.5 * (force_before - force).dot(slip) -
          0.5 * sum.dot(at_node(after.gap, i) - at_node(before.gap, k) + turned);
        index_before.erase(place);
      }
    for (const auto &[dof, k] : index_before) // contact nodes no longer
      step.time_stepping += 0.5 * at_node(before.force, k).dot(at_node(moved_before, k));
  }

  EnergyBalance::Step EnergyBalance::add_step(const LinearElasticity &elasticity,
                                              const ContactSurface &surface,
                                              const State &state)
  {
    const End before = std::exchange(last_, end_of(elasticity, surface, state));
    LA::Vector moved = last_.u;
    moved -= before.u;
    const auto mean_work = [&](const LA::Vector &a, const LA::Vector &b) {
      return 0.5 * (a * moved) + 0.5 * (b * moved);
    };
    Step step;
    step.loads          = mean_work(before.load, last_.load);
    step.supports       = mean_work(before.reaction, last_.reaction);
    step.elastic_change = mean_work(before.internal_force, last_.internal_force);
    step.elastic_energy = 0.5 * (last_.u * last_.internal_force);
    add_contact(step, before, last_, surface, state);
    const double energy_before = std::exchange(elastic_energy_, step.elastic_energy);
    if (std::exchange(is_carried_, false))
      {
        step.elastic_change = step.elastic_energy - energy_before;
        step.supports       = 0.;
        if (do_supports_move(elasticity, moved))
          step.supports -= lacking(step);
        else
          step.time_stepping += lacking(step);
        return step;
      }
    const double largest =
      std::max({std::abs(step.loads), std::abs(step.supports), std::abs(step.obstacles),
                std::abs(step.elastic_change), std::abs(step.dissipation),
                std::abs(step.time_stepping), least_part * step.elastic_energy});
    step.error = largest > 0. ? std::abs(lacking(step)) / largest : 0.;
    return step;
  }
} // namespace stiction
