#include <stiction/base/log.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of S: less is what rounding leaves of formulas.
    constexpr double no_load = 1e-13;

    // Sums over all nodes of the body.
    struct NodeSums
    {
      double loads = 0., reactions = 0.; // of the lengths of nodal forces
      double imbalance = 0.;
      double rounding  = 0.; // of K u
      // the most that K u is at a node, over K_jj times the largest displacement
      double resistance = 0.;
      double energy     = 0.; // uᵀKu
      double work       = 0.; // of loads and reactions
      double force      = 0.; // the largest resultant of a body
      double moment     = 0.; // the same, about the centre of all
      // of each body the lengths of loads, contact forces and reactions, and uᵀKu
      std::vector<double> of_bodies;
      std::vector<double> resultants; // of each body the force
    };

    // In one pass. contact_force: −Bᵀλ. Collective.
    NodeSums sum_over_nodes(const LinearElasticity &elasticity, const LA::Vector &u,
                            const LA::Vector &contact_force)
    {
      const Body &body       = elasticity.body();
      const LA::Vector &load = elasticity.load();
      const LA::Vector Ku    = elasticity.internal_force(u);
      const LA::Vector K     = elasticity.stiffness_diagonal();
      const Point<3> centre  = body.bounding_box().center();
      const double u_size    = u.linfty_norm();
      NodeSums sums;
      sums.of_bodies.resize(4 * body.pieces().size());
      // of each body first the force, then the moment
      std::vector<double> resultants(6 * body.pieces().size());
      for (const Body::Node &node : body.locally_owned_nodes())
        {
          Tensor<1, 3> applied, contact, reaction, residual, all, inside, held;
          for (unsigned int c = 0; c < 3; ++c)
            {
              const auto dof = node.dofs[c];
              const double f = load(dof);
              (elasticity.is_prescribed(dof) ? held : inside)[c] =
                unit_roundoff * K(dof) * u(dof);
              sums.resistance =
                std::max(sums.resistance, std::abs(Ku(dof)) / (K(dof) * u_size));
              applied[c] = f;
              contact[c] = contact_force(dof);
              all[c]     = f + contact[c];
              if (elasticity.is_prescribed(dof))
                {
                  reaction[c] = Ku(dof) - all[c];
                  all[c] += reaction[c];
                  sums.work += reaction[c] * u(dof);
                }
              else
                residual[c] = all[c] - Ku(dof);
              sums.work += f * u(dof);
              sums.of_bodies[4 * node.piece + 3] += u(dof) * Ku(dof);
            }
          double *const of_body = &sums.of_bodies[4 * node.piece];
          of_body[0] += applied.norm();
          of_body[1] += contact.norm();
          of_body[2] += reaction.norm();
          sums.loads += applied.norm();
          sums.reactions += reaction.norm();
          // a smaller residual than the rounding of its terms says nothing, such
          // as one that is zero because λ was made from K u
          sums.imbalance += std::max(residual.norm(), inside.norm());
          sums.rounding += (inside + held).norm();
          const Tensor<1, 3> moment = cross_product_3d(node.position - centre, all);
          for (unsigned int c = 0; c < 3; ++c)
            {
              resultants[6 * node.piece + c] += all[c];
              resultants[6 * node.piece + 3 + c] += moment[c];
            }
        }
      for (double *const sum :
           {&sums.loads, &sums.reactions, &sums.imbalance, &sums.rounding, &sums.work})
        *sum = Utilities::MPI::sum(*sum, body.communicator());
      Utilities::MPI::sum(resultants, body.communicator(), resultants);
      Utilities::MPI::sum(sums.of_bodies, body.communicator(), sums.of_bodies);
      sums.resistance = Utilities::MPI::max(sums.resistance, body.communicator());
      for (std::size_t i = 3; i < sums.of_bodies.size(); i += 4)
        sums.energy += sums.of_bodies[i];
      for (std::size_t i = 0; i < resultants.size(); i += 6)
        {
          const double *const r = &resultants[i];
          sums.resultants.push_back(std::hypot(r[0], r[1], r[2]));
          sums.force  = std::max(sums.force, sums.resultants.back());
          sums.moment = std::max(sums.moment, std::hypot(r[3], r[4], r[5]));
        }
      return sums;
    }
  } // namespace

  Certificate::Certificate(const LinearElasticity &elasticity,
                           const ContactSurface &surface, const State &state)
    : ContactConditions(state.lambda, surface.slip_bound().at(state.lambda))
    , elasticity_(elasticity)
    , surface_(surface)
  {
    gradient_ = surface.gap_and_slip(state);
    compute_body_figures(state);
    compute_contact_figures();
  }

  double Certificate::lost_between_sides() const
  {
    // what is no work in a motion of all bodies together is not lost
    const Eigen::Index m = surface_.n_nodes();
    Eigen::MatrixX3d lost(m, 3);
    for (unsigned int c = 0; c < 3; ++c)
      {
        LA::Vector u = elasticity_.zero_vector();
        for (const Body::Node &node : elasticity_.body().locally_owned_nodes())
          u(node.dofs[c]) = 1.;
        const Eigen::VectorXd relative = surface_.B().apply(u);
        for (Eigen::Index i = 0; i < m; ++i)
          lost(i, c) = at_node(lambda_, i).dot(at_node(relative, i));
      }
    double sum = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      if (surface_.boundary_of(surface_.nodes()[i]).is_pair())
        sum += lost.row(i).norm();
    return sum;
  }

  void Certificate::compute_body_figures(const State &state)
  {
    const LA::Vector &u      = state.u;
    LA::Vector contact_force = elasticity_.zero_vector();
    surface_.add_forces(-1., lambda_, contact_force);
    const NodeSums sums     = sum_over_nodes(elasticity_, u, contact_force);
    const Eigen::Index m    = surface_.n_nodes();
    const Eigen::VectorXd f = surface_.forces(lambda_);
    double contact_forces   = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      contact_forces += Tensor<1, 3>({f(i), f(i + m), f(i + 2 * m)}).norm();

    double S            = nonzero(std::max({sums.loads, sums.reactions, contact_forces}));
    double S_u0         = sums.energy;
    const double u_size = u.linfty_norm();
    // of bodies that are only moved by supports, and touch nothing or move together, S is
    // rounding: then what the displacement would take if it strained them
    bears_nothing_ = sums.rounding > 0. && sums.loads == 0. && contact_forces == 0. &&
                     sums.resistance <= reach_of_rounding(unit_roundoff) &&
                     (gradient_.head(m).array() >= -rounding_of_gaps * u_size).all();
    if (bears_nothing_)
      {
        S    = sums.rounding / unit_roundoff;
        S_u0 = S * u_size;
      }
    S                 = std::max(S, state.scales.least().force);
    S_u0              = std::max(S_u0, state.scales.least().energy);
    const double size = elasticity_.body().diameter();

    body_figures_.equilibrium_residual = sums.imbalance / S;
    body_figures_.force_balance        = std::max(sums.force, lost_between_sides()) / S;
    body_figures_.moment_balance       = sums.moment / (S * size);
    const auto n_bodies = static_cast<unsigned int>(sums.resultants.size());
    for (unsigned int p = 0; n_bodies > 1 && p < n_bodies; ++p)
      {
        const double *const on_body = &sums.of_bodies[4 * p];
        const double most           = *std::max_element(on_body, on_body + 3);
        if (on_body[0] > no_load * std::max(S, state.scales.force) &&
            sums.resultants[p] > worst_balanced_.lacking * most)
          worst_balanced_ = {p, sums.resultants[p] / most};
      }
    if (surface_.motion().n_pressed() > 0)
      body_figures_.obstacle_force = surface_.motion().force_error(lambda_);
    rounding_      = sums.rounding / S;
    force_scale_   = S;
    energy_scale_  = S_u0;
    strain_energy_ = sums.energy / 2.;
    load_work_     = sums.work;
    for (unsigned int p = 0; p < n_bodies; ++p)
      strain_energies_.push_back(sums.of_bodies[4 * p + 3] / 2.);

    scaling_ = contact_scaling(S, S_u0, surface_.areas(), surface_.boundary_area(),
                               surface_.stiffness());
  }

  std::vector<std::pair<std::string, double>> Certificate::deciding_figures() const
  {
    auto figures = ContactConditions::deciding_figures();
    figures.emplace(figures.begin(), "equilibrium_residual",
                    body_figures_.equilibrium_residual);
    figures.emplace_back("force_balance", body_figures_.force_balance);
    figures.emplace_back("moment_balance", body_figures_.moment_balance);
    if (body_figures_.obstacle_force >= 0.)
      figures.emplace_back("obstacle_force", body_figures_.obstacle_force);
    return figures;
  }

  std::string Certificate::why_out_of_reach(const double tolerance) const
  {
    const std::string why = ContactConditions::why_out_of_reach(tolerance);
    const double ratio    = elasticity_.materials().largest_youngs_modulus() /
                         elasticity_.materials().smallest_youngs_modulus();
    return why.empty() || ratio * unit_roundoff <= tolerance
             ? why
             : why + format("; Young's moduli differ by a factor of %.2g: let something "
                            "rigid ('Obstacle', 'Prescribed displacement') stand for "
                            "what is so much stiffer, or make it less stiff",
                            ratio);
  }

  bool Certificate::is_solved(const double tolerance) const
  {
    const std::set<std::string> of_places =
      elasticity_.free_motions().n() > 0
        ? std::set<std::string>{"obstacle_force", "equilibrium_residual", "force_balance",
                                "moment_balance"}
        : std::set<std::string>{"obstacle_force"};
    const auto figures = deciding_figures();
    return std::all_of(figures.begin(), figures.end(), [&](const auto &figure) {
      return of_places.count(figure.first) > 0 || figure.second <= tolerance;
    });
  }
} // namespace stiction
