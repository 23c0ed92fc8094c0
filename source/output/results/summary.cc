#include <stiction/base/mesh_names.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/certificate/error_estimator.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/support_reactions.h>
#include <stiction/output/results/output_directory.h>
#include <stiction/output/results/summary.h>
#include <stiction/parameters/parameters.h>
#include <stiction/qp/certified_solve.h>
#include <stiction/qp/methods/dual_method.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace stiction
{
  namespace
  {
    using nlohmann::json;

    json to_json(const dealii::Tensor<1, 3> &v)
    {
      return {v[0], v[1], v[2]};
    }

    // How many nodes do what.
    class StatusCounts
    {
    public:
      void add(const NodeStatus status)
      {
        ++normal_[static_cast<unsigned int>(status.normal)];
        ++tangential_[static_cast<unsigned int>(status.tangential)];
        undecided_ += status.is_undecided() ? 1 : 0;
      }

      json to_json() const
      {
        return {{"open", at(NormalStatus::open)},
                {"closed", at(NormalStatus::closed)},
                {"undecided_normal", at(NormalStatus::undecided)},
                {"slip", at(TangentialStatus::slip)},
                {"stick", at(TangentialStatus::stick)},
                {"undecided_tangential", at(TangentialStatus::undecided)},
                {"undecided", undecided_}};
      }

    private:
      unsigned int at(const NormalStatus status) const
      {
        return normal_[static_cast<unsigned int>(status)];
      }

      unsigned int at(const TangentialStatus status) const
      {
        return tangential_[static_cast<unsigned int>(status)];
      }

      std::array<unsigned int, 4> normal_{}, tangential_{};
      unsigned int undecided_ = 0;
    };

    // What happens on a contact boundary, or on all of them.
    struct ContactPart
    {
      unsigned int nodes = 0;
      StatusCounts counts;
      double normal_force = 0., area = 0., max_pressure = 0.;
      dealii::Tensor<1, 3> force_on_body, tangential_force, moment;

      void add(const ContactSurface &surface, const Certificate &certificate,
               const NodeStatus status, const Eigen::Index i)
      {
        const ContactNode &node  = surface.nodes()[i];
        const double normal_part = certificate.lambda()(i);
        const Eigen::Vector3d on_obstacle =
          node.force_to_cartesian(at_node(certificate.lambda(), i));
        const dealii::Tensor<1, 3> force(
          {-on_obstacle(0), -on_obstacle(1), -on_obstacle(2)});

        ++nodes;
        counts.add(status);
        if (status.normal == NormalStatus::closed)
          area += node.area;
        normal_force += normal_part;
        max_pressure = std::max(max_pressure, normal_part / node.area);
        force_on_body += force;
        tangential_force += force + normal_part * node.normal;
        moment += cross_product_3d(node.position, force);
      }

      json to_json() const
      {
        json result = counts.to_json();
        result.update(json({{"normal_force", normal_force},
                            {"tangential_force", stiction::to_json(tangential_force)},
                            {"force_on_body", stiction::to_json(force_on_body)},
                            {"moment", stiction::to_json(moment)},
                            {"max_pressure", max_pressure},
                            {"area", area}}));
        return result;
      }
    };
  } // namespace

  json head_of_summary(const SolveStatus &solution, const Parameters &parameters,
                       MPI_Comm communicator)
  {
    return {{"program", program_to_json(communicator)},
            {"converged", solution.converged},
            {"interrupted", solution.interrupted},
            {"units", units_to_json(parameters.output.units)},
            {"input", parameters.source.given()}};
  }

  json certificate_to_json(const ContactConditions &conditions)
  {
    const auto &figures = conditions.contact_figures();
    json result         = {{"equilibrium_residual", nullptr},
                           {"kkt_residual", figures.kkt_residual},
                           {"penetration", figures.penetration},
                           {"complementarity", figures.complementarity},
                           {"cone_violation", figures.cone_violation},
                           {"slip_angle", figures.slip_angle},
                           {"rounding", conditions.rounding()},
                           {"force_balance", nullptr},
                           {"moment_balance", nullptr},
                           {"obstacle_force", nullptr},
                           {"duality_gap", nullptr}};
    if (const auto *certificate = dynamic_cast<const Certificate *>(&conditions))
      {
        const auto &body               = certificate->body_figures();
        result["equilibrium_residual"] = body.equilibrium_residual;
        result["force_balance"]        = body.force_balance;
        result["moment_balance"]       = body.moment_balance;
        if (body.obstacle_force >= 0.)
          result["obstacle_force"] = body.obstacle_force;
        if (body.duality_gap >= 0.)
          result["duality_gap"] = body.duality_gap;
      }
    return result;
  }

  json counts_to_json(const std::vector<NodeStatus> &statuses)
  {
    StatusCounts counts;
    for (const NodeStatus status : statuses)
      counts.add(status);
    return counts.to_json();
  }

  json solver_to_json(const ContactSolverParameters &parameters,
                      const qp::SlipBound &slip_bound, const DualMethod &method,
                      const DualOperator &Q)
  {
    const DualMethodStatistics statistics = method.statistics();
    const bool has_friction               = !slip_bound.constant().isZero(0.);
    return {{"law", slip_bound.is_mixed()     ? "mixed"
                    : slip_bound.is_coulomb() ? "coulomb"
                    : has_friction            ? "given"
                                              : "frictionless"},
            {"method", parameters.method},
            {"coulomb_iterations", statistics.coulomb_iterations},
            {"gauss_seidel_iterations", statistics.gauss_seidel_iterations},
            {"newton_steps", statistics.newton_steps},
            {"krylov_iterations", statistics.krylov_iterations},
            {"interior_point_steps", statistics.interior_point_steps},
            {"conjugate_gradient_steps", statistics.conjugate_gradient_steps},
            {"expansion_steps", statistics.expansion_steps},
            {"release_steps", statistics.release_steps},
            {"admm_iterations", statistics.admm_iterations},
            {"dense_factorizations", statistics.dense_factorizations},
            {"fallbacks", statistics.fallbacks},
            {"contraction", statistics.coulomb_iterations > 0
                              ? json(statistics.contraction)
                              : json(nullptr)},
            // parts of products make up whole ones
            {"dual_multiplications",
             static_cast<unsigned long>(std::ceil(Q.n_multiplications()))}};
  }

  json solver_to_json(const ContactSolverParameters &parameters,
                      const NewtonMultigrid &newton)
  {
    json levels                = json::array();
    unsigned int rho_changes   = 0;
    unsigned int fallbacks     = 0;
    unsigned int coarse_krylov = 0;
    for (unsigned int l = 0; l < newton.statistics().size(); ++l)
      {
        const LevelNewton::Statistics &level = newton.statistics()[l];
        levels.push_back(
          {{"dofs", newton.n_dofs(l)},
           {"newton_steps", level.newton_steps},
           {"krylov_iterations", level.krylov_iterations},
           {"factorized_from_step",
            level.factorized_from > 0 ? json(level.factorized_from) : json(nullptr)}});
        rho_changes += level.rho_changes;
        fallbacks += level.fallbacks;
        if (l != newton.finest_level())
          coarse_krylov += level.krylov_iterations;
      }
    const LevelNewton::Statistics &finest = newton.statistics().back();
    return {{"method", parameters.method},
            {"coulomb_iterations", 0},
            {"gauss_seidel_iterations", 0},
            {"newton_steps", finest.newton_steps},
            {"krylov_iterations", finest.krylov_iterations},
            {"coarse_krylov_iterations", coarse_krylov},
            {"levels", levels},
            {"rho_changes", rho_changes},
            {"interior_point_steps", 0},
            {"conjugate_gradient_steps", 0},
            {"expansion_steps", 0},
            {"release_steps", 0},
            {"admm_iterations", 0},
            {"dense_factorizations", 0},
            {"fallbacks", fallbacks},
            {"contraction", nullptr},
            {"stiffness_solves", 0},
            {"dual_multiplications", 0}};
  }

  json contact_to_json(const ContactSurface &surface, const State &state,
                       const Certificate &certificate,
                       const std::vector<NodeStatus> &statuses)
  {
    ContactPart all;
    std::vector<ContactPart> parts(surface.boundaries().size());
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        all.add(surface, certificate, statuses[i], i);
        parts[surface.nodes()[i].boundary].add(surface, certificate, statuses[i], i);
      }

    json result          = all.to_json();
    result["boundaries"] = json::array();
    for (std::size_t b = 0; b < parts.size(); ++b)
      {
        const ContactBoundary &boundary = surface.boundaries()[b];
        json part                       = parts[b].to_json();
        part["name"]                    = boundary.name();
        part["id"]                      = boundary.id();
        part["nodes"]                   = parts[b].nodes;
        part["obstacle_displacement"] =
          to_json(surface.obstacle_displacement(boundary.id(), state.distances));
        result["boundaries"].push_back(part);
      }
    return result;
  }

  json reactions_to_json(const SupportReactions &reactions, const MeshNames &names)
  {
    json result = {{"boundaries", json::array()}, {"points", json::array()}};
    for (const auto &boundary : reactions.boundaries())
      result["boundaries"].push_back({{"name", names.name(boundary.first)},
                                      {"id", boundary.first},
                                      {"force", to_json(boundary.second.force)},
                                      {"moment", to_json(boundary.second.moment)}});
    for (const auto &point : reactions.points())
      result["points"].push_back({{"at", {point.at[0], point.at[1], point.at[2]}},
                                  {"force", to_json(point.force)}});
    return result;
  }

  json boundaries_to_json(const MeshNames &names)
  {
    json result = json::array();
    for (const auto id : names.ids())
      result.push_back({{"id", id}, {"name", names.name(id)}});
    return result;
  }

  json units_to_json(const std::string &name)
  {
    const Units units = Units::named(name);
    return {{"name", name == "none" ? "" : name},
            {"length", units.length},
            {"area", units.area},
            {"force", units.force},
            {"moment", units.moment},
            {"stress", units.stress},
            {"energy", units.energy},
            {"density", units.density}};
  }

  json energy_to_json(const ContactSurface &surface, const Certificate &certificate)
  {
    // Σ λ_t · slip, and r_t = −slip
    const Eigen::Index n = 2 * surface.n_nodes();
    return {{"strain", certificate.strain_energy()},
            {"load_work", certificate.load_work()},
            {"friction_dissipation",
             0. - certificate.lambda().tail(n).dot(certificate.gradient().tail(n))}};
  }

  json mesh_error_to_json(const MeshError &error, const double strain_energy)
  {
    if (error.n_cells == 0)
      return nullptr;
    return {{"relative_energy_error",
             strain_energy > 0. ? std::sqrt(error.square / (2. * strain_energy)) : 0.},
            {"sampled", error.is_sampled},
            {"cells_sampled", error.n_cells}};
  }

  json displacement_to_json(const LinearElasticity &elasticity, const LA::Vector &u)
  {
    // the first component is the size, so that the largest array is the one
    // sought; ties go to the largest place, on any number of ranks
    std::array<double, 4> largest{{-1., 0., 0., 0.}};
    for (const Body::Node &node : elasticity.body().locally_owned_nodes())
      {
        dealii::Tensor<1, 3> displacement;
        for (unsigned int c = 0; c < 3; ++c)
          displacement[c] = u(node.dofs[c]);
        largest = std::max(largest, {{displacement.norm(), node.position[0],
                                      node.position[1], node.position[2]}});
      }
    for (const auto &theirs :
         dealii::Utilities::MPI::all_gather(elasticity.body().communicator(), largest))
      largest = std::max(largest, theirs);
    return {{"max", largest[0]}, {"at", {largest[1], largest[2], largest[3]}}};
  }

} // namespace stiction
