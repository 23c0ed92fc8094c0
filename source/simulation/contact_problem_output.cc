// What a problem writes and says once it is solved.

#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/support_reactions.h>
#include <stiction/output/problem/problem_files.h>
#include <stiction/output/results/convergence_history.h>
#include <stiction/output/results/nodal_values.h>
#include <stiction/output/results/output_directory.h>
#include <stiction/output/results/report.h>
#include <stiction/output/results/summary.h>
#include <stiction/output/results/vtu.h>
#include <stiction/parameters/parameters.h>
#include <stiction/qp/advice.h>
#include <stiction/qp/dual_problem.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/simulation/adaptive_refinement.h>
#include <stiction/simulation/contact_problem.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <nlohmann/json.hpp>

namespace stiction
{
  using nlohmann::json;

  std::vector<NodeStatus> ContactProblem::node_statuses() const
  {
    // that of a patch of a half-space
    const Eigen::VectorXd stiffness =
      discretization_->surface->stiffness().youngs_moduli.cwiseProduct(
        discretization_->surface->areas().cwiseSqrt());
    return stiction::node_statuses(*certificate_, discretization_->surface->slip_bound(),
                                   stiffness, parameters_.contact_solver.tolerance);
  }

  void ContactProblem::output_results()
  {
    const auto phase               = phases_.scope("output");
    const OutputParameters &output = parameters_.output;
    const LA::Vector &u            = state_.u;
    LA::Vector contact_force       = discretization_->elasticity->zero_vector();
    discretization_->surface->B().add_transpose(-1., state_.lambda, contact_force);
    reactions_ =
      std::make_unique<SupportReactions>(*discretization_->elasticity, u, contact_force);
    if (output.write_solution)
      write_solution(*discretization_->elasticity, u, reactions_->nodal(),
                     refinement_ ? refinement_->indicators() : dealii::Vector<double>(),
                     output);
    const std::vector<NodeStatus> statuses = node_statuses();
    write_contact(*discretization_->elasticity, u, *discretization_->surface,
                  *certificate_, statuses, output);
    if (output.double_precision)
      {
        write_nodal_displacement(output.directory, *body_, u, reactions_->nodal());
        write_contact_nodes(output.directory, *discretization_->surface, *certificate_,
                            statuses, communicator_);
      }
    write_obstacles(output.directory, *discretization_->elasticity,
                    *discretization_->surface, state_);
    write_history(*history_, output.directory, communicator_);
  }

  void ContactProblem::export_problem()
  {
    const std::string &directory = parameters_.output.export_directory;
    if (directory.empty())
      return;
    const auto phase = phases_.scope("output");
    throw_on_all_ranks(communicator_, [&]() {
      if (dealii::Utilities::MPI::this_mpi_process(communicator_) != 0)
        return;
      const DualOperator &Q = *discretization_->solver->dual_operator();
      DualProblem problem;
      problem.Q = *Q.matrix();
      problem.h = Q.right_hand_side() +
                  discretization_->surface->motion().offset_at_start() -
                  discretization_->surface->motion().offset(state_.distances);
      problem.slip_bound = discretization_->surface->slip_bound();
      problem.areas      = discretization_->surface->areas();
      problem.positions.resize(discretization_->surface->n_nodes(), 3);
      for (Eigen::Index i = 0; i < discretization_->surface->n_nodes(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          problem.positions(i, c) = discretization_->surface->nodes()[i].position[c];
      stiction::export_problem(directory, problem, state_.lambda,
                               certificate_->gradient());
    });
  }

  void ContactProblem::summarize()
  {
    const bool measured            = elastic_solve_iterations_ > 0;
    const Certificate &certificate = *certificate_;

    summary_ =
      std::make_unique<json>(head_of_summary(status_, parameters_, communicator_));
    json &summary      = *summary_;
    summary["problem"] = {{"cells", body_->triangulation().n_global_active_cells()},
                          {"nodes", body_->n_nodes()},
                          {"dofs", body_->dof_handler().n_dofs()},
                          {"contact_nodes", discretization_->surface->n_nodes()},
                          {"dual_unknowns", 3 * discretization_->surface->n_nodes()},
                          {"boundaries", boundaries_to_json(body_->boundary_names())}};
    summary["solver"]  = discretization_->solver->to_json();
    summary["solver"].update(json(
      {{"law", parameters_.friction.name()},
       {"tolerance", parameters_.contact_solver.tolerance},
       {"elastic_solve_iterations",
        measured ? json(elastic_solve_iterations_) : json(nullptr)},
       {"elastic_solve_equivalents", measured ? json(phases_.seconds("contact_solve") /
                                                     phases_.seconds("elastic_solve"))
                                              : json(nullptr)}}));
    summary["certificate"] = certificate_to_json(certificate);
    summary["contact"] =
      contact_to_json(*discretization_->surface, state_, certificate, node_statuses());
    summary["reactions"] = reactions_to_json(*reactions_, body_->boundary_names());
    summary["displacement"] =
      displacement_to_json(*discretization_->elasticity, state_.u);
    summary["energy"]     = energy_to_json(*discretization_->surface, certificate);
    summary["mesh_error"] = mesh_error_to_json(mesh_error_, certificate.strain_energy());
    summary["warnings"]   = warnings();
    if (refinement_)
      summary["refinement"] = refinement_->to_json();
    summary["seconds"]        = phases_.to_json();
    summary["peak_memory_MB"] = peak_memory(communicator_);
    write_summary(summary, parameters_.output.directory, communicator_);
  }

  std::vector<std::string> ContactProblem::warnings() const
  {
    std::vector<std::string> warnings;
    if (parameters_.has_locking())
      warnings.push_back(
        format("with a Poisson ratio of %g trilinear elements lock, bodies and "
               "forces become too stiff, which the certificate does not see: "
               "'Material/Volume strain = cell mean' does not lock.",
               parameters_.material.largest_poisson_ratio()));
    const std::string friction =
      warning_on_friction(discretization_->surface->largest_coefficient());
    if (status_.converged && !friction.empty())
      warnings.push_back(friction);
    const double depth = status_.converged
                           ? discretization_->surface->penetration_of_facing_away(state_)
                           : 0.;
    if (depth > 1e-6 * (*summary_)["displacement"]["max"].get<double>())
      warnings.push_back(
        "a node that faces away from its obstacle came " +
        with_unit(format("%.2g", depth), Units::named(parameters_.output.units).length) +
        " into it; such nodes are no contact nodes, and the certificate does "
        "not speak of them.");
    return warnings;
  }

  void ContactProblem::report() const
  {
    const std::string &directory = parameters_.output.directory;
    print_report(*log_, *summary_, parameters_.contact_solver.tolerance,
                 explain(status_, *certificate_, parameters_.contact_solver.tolerance),
                 parameters_.performance.print_timing);
    const std::string mesh = describe_mesh_error((*summary_)["mesh_error"], parameters_);
    if (!mesh.empty())
      log_->line(mesh);
    for (const auto &warning : (*summary_)["warnings"])
      log_->line("WARNING: " + warning.get<std::string>());
    log_->line("Open " +
               (parameters_.output.write_solution ? directory + "/solution.pvtu and "
                                                  : std::string()) +
               directory + "/contact.pvtu in ParaView.");
    if (!parameters_.output.export_directory.empty())
      log_->line("The discrete problem is in " + parameters_.output.export_directory +
                 ".");
  }
} // namespace stiction
