#include <stiction/base/phases.h>
#include <stiction/base/text/mesh_names.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/certificate/error_estimator.h>
#include <stiction/contact/dual/contact_solver_parameters.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/output/output_parameters.h>
#include <stiction/output/results/nodal_values.h>
#include <stiction/output/results/report.h>
#include <stiction/output/results/run_result.h>
#include <stiction/output/tensor_json.h>
#include <stiction/qp/certified_solve.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stiction
{
  using nlohmann::json;

  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Units, length, area, force, moment, stress, energy,
                                     density)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunResult::NodeCounts, open, closed,
                                     undecided_normal, slip, stick, undecided_tangential,
                                     tied, undecided)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunResult::Support, name, id, force, moment)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SupportReactions::AtPoint, at, force)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunResult::Displacement, max, at)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunResult::Energy, strain, load_work,
                                     friction_dissipation)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunResult::RelativeMeshError, relative_energy_error,
                                     sampled, cells_sampled)

  namespace
  {
    json with(json entries, const json &more)
    {
      entries.update(more);
      return entries;
    }

    template<typename Value> json value_or_null(const bool has_value, const Value &value)
    {
      return has_value ? json(value) : json(nullptr);
    }
  } // namespace

  static void to_json(json &section, const RunResult::Contact &contact)
  {
    section = with(static_cast<const RunResult::NodeCounts &>(contact),
                   {{"normal_force", contact.normal_force},
                    {"tangential_force", contact.tangential_force},
                    {"force_on_body", contact.force_on_body},
                    {"moment", contact.moment},
                    {"max_pressure", contact.max_pressure},
                    {"max_mean_pressure", contact.max_mean_pressure},
                    {"max_tension", contact.max_tension},
                    {"max_tied_traction", contact.max_tied_traction},
                    {"area", contact.area}});
  }

  static void to_json(json &entry, const RunResult::ContactPart &part)
  {
    entry = with(static_cast<const RunResult::Contact &>(part),
                 {{"name", part.name},
                  {"pair", part.section_name},
                  {"id", part.id},
                  {"nodes", part.nodes},
                  {"opposite", part.opposite},
                  {"of_opposite", json::array()},
                  {"obstacle_displacement", part.obstacle_displacement},
                  {"obstacle_rotation", part.obstacle_rotation},
                  {"torque", part.torque}});
    for (const auto &[name, force] : part.of_opposite)
      entry["of_opposite"].push_back({{"name", name}, {"force_on_body", force}});
  }

  static void to_json(json &entry, const RunResult::Solver::Level &level)
  {
    entry = {{"dofs", level.dofs},
             {"newton_steps", level.newton_steps},
             {"krylov_iterations", level.krylov_iterations},
             {"factorized_from_step",
              value_or_null(level.factorized_from_step > 0, level.factorized_from_step)}};
  }

  namespace
  {
    json solver_to_json(const RunResult &result,
                        const ContactSolverParameters &parameters)
    {
      const RunResult::Solver &solver = result.solver;
      json section                    = {
                           {"law", solver.law},
                           {"method", parameters.method},
                           {"tolerance", parameters.tolerance},
                           {"contraction", value_or_null(solver.coulomb_iterations > 0, solver.contraction)},
                           {"dual_multiplications", solver.dual_multiplications}};
      if (!solver.handed_over_to.empty())
        section["handed_over_to"] = solver.handed_over_to;
      for (const qp::IterationCount &count : qp::iteration_counts)
        section[count.name] = solver.*count.number;
      if (!result.has_body)
        return section;

      const bool measured = solver.elastic_solve_iterations > 0;
      section.update(json({{"stiffness_solves", solver.stiffness_solves},
                           {"elastic_solve_iterations",
                            value_or_null(measured, solver.elastic_solve_iterations)},
                           {"elastic_solve_equivalents",
                            value_or_null(measured, solver.elastic_solve_equivalents)}}));
      if (solver.levels.empty())
        section["stiffness_krylov_iterations"] = solver.stiffness_krylov_iterations;
      else
        section.update(
          json({{"levels", solver.levels},
                {"coarse_krylov_iterations", solver.coarse_krylov_iterations},
                {"rho_changes", solver.rho_changes}}));
      return section;
    }

    json certificate_to_json(const RunResult &result)
    {
      json section = {{"rounding", result.rounding}};
      for (const char *name : {"equilibrium_residual", "force_balance", "moment_balance",
                               "obstacle_force", "duality_gap"})
        section[name] = nullptr; // without a body, or not computed
      for (const RunResult::Figure &figure : result.certificate)
        section[figure.name] = figure.value;
      if (!result.has_body)
        section["has_body"] = false;
      return section;
    }

    void count(RunResult::NodeCounts &counts, const NodeStatus status)
    {
      counts.open += status.normal == NormalStatus::open ? 1 : 0;
      const bool is_tied = status.tangential == TangentialStatus::tied;
      counts.tied += is_tied ? 1 : 0;
      counts.closed += status.normal == NormalStatus::closed && !is_tied ? 1 : 0;
      counts.undecided_normal += status.normal == NormalStatus::undecided ? 1 : 0;
      counts.slip += status.tangential == TangentialStatus::slip ? 1 : 0;
      counts.stick += status.tangential == TangentialStatus::stick ? 1 : 0;
      counts.undecided_tangential +=
        status.tangential == TangentialStatus::undecided ? 1 : 0;
      counts.undecided += status.is_undecided() ? 1 : 0;
    }

    // Returns the force of friction on the body.
    //
    // @param is_outer whether something rigid bears the opposite: of pairs, forces and
    //   moments on all bodies together are none.
    dealii::Tensor<1, 3> add_forces(RunResult::Contact &contact, const ContactNode &node,
                                    const Eigen::Vector3d &lambda,
                                    const NodeStatus status, const bool is_outer = true)
    {
      const dealii::Tensor<1, 3> force    = -to_tensor(node.force_to_cartesian(lambda)),
                                 friction = -to_tensor(
                                   node.force_to_cartesian({0., lambda(1), lambda(2)}));
      if (status.normal == NormalStatus::closed)
        contact.area += node.area;
      contact.normal_force += lambda(0);
      contact.tangential_force += friction;
      if (is_outer)
        {
          contact.force_on_body += force;
          contact.moment += cross_product_3d(node.center, force);
        }
      return friction;
    }

    void add_tractions(RunResult::Contact &contact, const ContactNode &node,
                       const Eigen::Vector3d &lambda, const double around,
                       const bool is_tied)
    {
      contact.max_pressure      = std::max(contact.max_pressure, lambda(0) / node.area);
      contact.max_mean_pressure = std::max(contact.max_mean_pressure, around);
      if (!is_tied)
        return;
      contact.max_tension       = std::max(contact.max_tension, -lambda(0) / node.area);
      contact.max_tied_traction = std::max(
        contact.max_tied_traction, node.force_to_cartesian(lambda).norm() / node.area);
    }

    // Collective.
    RunResult::Displacement largest_displacement(const Body &body, const LA::Vector &u)
    {
      // the first component is the size, so that the largest array is the one
      // sought; ties go to the largest place, on any number of ranks
      std::array<double, 4> largest{{-1., 0., 0., 0.}};
      for (const Body::Node &node : body.locally_owned_nodes())
        {
          dealii::Tensor<1, 3> displacement;
          for (unsigned int c = 0; c < 3; ++c)
            displacement[c] = u(node.dofs[c]);
          largest = std::max(largest, {{displacement.norm(), node.position[0],
                                        node.position[1], node.position[2]}});
        }
      for (const auto &theirs :
           dealii::Utilities::MPI::all_gather(body.communicator(), largest))
        largest = std::max(largest, theirs);
      return {largest[0], dealii::Point<3>(largest[1], largest[2], largest[3])};
    }
  } // namespace

  RunResult result_of(const SolveStatus &solution, const ContactConditions &conditions,
                      const std::vector<NodeStatus> &statuses, const double tolerance,
                      const OutputParameters &output, const Phases &phases,
                      MPI_Comm communicator)
  {
    RunResult result;
    result.converged   = solution.converged;
    result.interrupted = solution.interrupted;
    result.reason      = explain(solution, conditions, tolerance);
    result.units       = Units::named(output.units);
    for (const auto &[name, value] : conditions.deciding_figures())
      result.certificate.push_back({name, value, true});
    result.certificate.push_back(
      {"slip_angle", conditions.contact_figures().slip_angle, false});
    result.rounding = conditions.rounding();
    for (const NodeStatus status : statuses)
      count(result.contact, status);
    result.contact.normal_force =
      conditions.lambda().head(conditions.lambda().size() / 3).sum();
    result.seconds = phases.all_seconds();

    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    result.peak_memory_MB = dealii::Utilities::MPI::sum(
      static_cast<double>(memory.VmHWM) / 1024., communicator);
    return result;
  }

  void add_method(RunResult::Solver &solver, const DualMethodStatistics &method,
                  const DualOperator &Q)
  {
    static_cast<DualMethodStatistics &>(solver) = method;
    // parts of products make up whole ones
    solver.dual_multiplications =
      static_cast<unsigned long>(std::ceil(Q.n_multiplications()));
  }

  void add_method(RunResult::Solver &solver, const NewtonMultigrid &newton)
  {
    solver.coarse_krylov_iterations += solver.krylov_iterations; // on a coarser mesh
    for (unsigned int l = 0; l < newton.statistics().size(); ++l)
      {
        const LevelNewton::Statistics &level = newton.statistics()[l];
        solver.levels.push_back({newton.n_dofs(l), level.newton_steps,
                                 level.krylov_iterations, level.factorized_from});
        solver.rho_changes += level.rho_changes;
        solver.fallbacks += level.fallbacks;
        solver.interior_point_steps += level.interior_point_steps;
        if (l != newton.finest_level())
          solver.coarse_krylov_iterations += level.krylov_iterations;
      }
    solver.newton_steps      = newton.statistics().back().newton_steps;
    solver.krylov_iterations = newton.statistics().back().krylov_iterations;
  }

  void add_body(RunResult &result, const Body &body, const ContactSurface &surface,
                const State &state, const Certificate &certificate,
                const std::vector<NodeStatus> &statuses,
                const SupportReactions &reactions, const MeshError &mesh_error)
  {
    result.has_body     = true;
    const auto &figures = certificate.body_figures();
    if (figures.duality_gap >= 0.)
      result.certificate.push_back({"duality_gap", figures.duality_gap, false});

    result.contact.normal_force = 0.; // in the order of the other sums
    for (const ContactBoundary &boundary : surface.boundaries())
      {
        RunResult::ContactPart part;
        part.name         = boundary.name();
        part.title        = boundary.title();
        part.section_name = boundary.section_name();
        part.opposite     = boundary.partner_name();
        part.id           = boundary.id();
        part.obstacle_displacement =
          surface.obstacle_displacement(boundary.id(), state.distances);
        part.obstacle_rotation = boundary.angle() * boundary.axis();
        result.boundaries.push_back(part);
      }
    const Eigen::VectorXd around =
      pressure_around(body, surface, certificate.lambda().head(surface.n_nodes()));
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node      = surface.nodes()[i];
        const Eigen::Vector3d lambda = at_node(certificate.lambda(), i);
        RunResult::ContactPart &part = result.boundaries[node.boundary];
        ++part.nodes;
        count(part, statuses[i]);
        part.torque += node.arm * add_forces(part, node, lambda, statuses[i]);
        const bool is_tied = statuses[i].tangential == TangentialStatus::tied;
        add_tractions(part, node, lambda, around(i), is_tied);
        add_tractions(result.contact, node, lambda, around(i), is_tied);
        // sums of contact are without what ties bear
        if (!is_tied)
          add_forces(result.contact, node, lambda, statuses[i], part.opposite.empty());
      }

    for (const auto &[id, support] : reactions.boundaries())
      result.supports.push_back({support, body.boundary_names().name(id), id});
    result.points       = reactions.points();
    result.displacement = largest_displacement(body, state.u);
    // Σ λ_t · slip, and r_t = −slip
    const Eigen::Index n = 2 * surface.n_nodes();
    const double dissipation =
      0. - certificate.lambda().tail(n).dot(certificate.gradient().tail(n));
    result.energy = {certificate.strain_energy(), certificate.load_work(), dissipation};
    const double norm_square = 2. * certificate.strain_energy();
    result.mesh_error = {norm_square > 0. ? std::sqrt(mesh_error.square / norm_square)
                                          : 0.,
                         mesh_error.is_sampled, mesh_error.n_cells};
  }

  json to_json(const RunResult &result, const ContactSolverParameters &solver,
               const std::string &units, const ParameterFile &source,
               MPI_Comm communicator)
  {
    json summary = {
      {"program",
       {{"name", "stiction"},
        {"version", STICTION_VERSION},
        {"dealii", DEAL_II_PACKAGE_VERSION},
        {"build_type", STICTION_BUILD_TYPE},
        {"ranks", dealii::Utilities::MPI::n_mpi_processes(communicator)}}},
      {"converged", result.converged},
      {"interrupted", result.interrupted},
      {"reason", result.converged ? "" : result.reason},
      {"units", with(result.units, {{"name", units == "none" ? "" : units}})},
      {"input", source.given()},
      {"solver", solver_to_json(result, solver)},
      {"certificate", certificate_to_json(result)},
      {"peak_memory_MB", result.peak_memory_MB}};
    for (const auto &[phase, seconds] : result.seconds)
      summary["seconds"][phase] =
        value_or_null(seconds.has_value(), seconds.value_or(0.));
    if (!result.has_body)
      {
        summary["contact"] =
          with(static_cast<const RunResult::NodeCounts &>(result.contact),
               {{"normal_force", result.contact.normal_force}});
        return summary;
      }
    summary["contact"]   = with(result.contact, {{"boundaries", result.boundaries}});
    summary["reactions"] = {{"boundaries", result.supports}, {"points", result.points}};
    summary["displacement"] = result.displacement;
    summary["energy"]       = result.energy;
    summary["mesh_error"] =
      value_or_null(result.mesh_error.cells_sampled > 0, result.mesh_error);
    summary["warnings"] = result.warnings;
    return summary;
  }
} // namespace stiction
