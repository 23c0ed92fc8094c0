// What a problem writes and says once it is solved.

#include <stiction/base/errors.h>
#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/certificate/pair_figures.h>
#include <stiction/contact/dual/rigid_balance.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/support_reactions.h>
#include <stiction/output/history/step_history.h>
#include <stiction/output/problem/problem_files.h>
#include <stiction/output/results/convergence_history.h>
#include <stiction/output/results/nodal_values.h>
#include <stiction/output/results/output_directory.h>
#include <stiction/output/results/report.h>
#include <stiction/output/results/run_result.h>
#include <stiction/output/results/vtu.h>
#include <stiction/qp/dual_problem.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/simulation/adaptive_refinement.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/time_steps.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <nlohmann/json.hpp>

namespace stiction
{
  using nlohmann::json;

  std::vector<NodeStatus> ContactProblem::node_statuses() const
  {
    const ContactSurface &surface = contact_surface();
    // that of a patch of a half-space
    const Eigen::VectorXd stiffness =
      surface.stiffness().youngs_moduli.cwiseProduct(surface.areas().cwiseSqrt());
    return stiction::node_statuses(*certificate_, surface.slip_bound(), stiffness,
                                   parameters_.contact_solver.tolerance);
  }

  LA::Vector ContactProblem::contact_force() const
  {
    LA::Vector force = elasticity().zero_vector();
    contact_surface().add_forces(-1., state_.lambda, force);
    return force;
  }

  void ContactProblem::compute_reactions()
  {
    reactions_ =
      std::make_unique<SupportReactions>(elasticity(), state_.u, contact_force());
  }

  void ContactProblem::output_results()
  {
    const auto phase = phases_.scope("output");
    compute_reactions();
    if (!steps_)
      write_fields("");
    else if (!status_.converged && !ends_between_steps_)
      write_fields("_uncertified");
    else if (!is_step_written_)
      write_step();
    write_history(*history_, parameters_.output.directory, communicator_);
  }

  void ContactProblem::record_step(const TimeSteps &times,
                                   const EnergyBalance::Step &energy)
  {
    const auto phase      = phases_.scope("output");
    const auto &surface   = contact_surface();
    const StepResult step = {
      times.n_taken(),
      times.reached(),
      certificate_->worst_figure().second,
      boundary_steps(surface, state_, *certificate_, node_statuses()),
      energy,
      effort_};
    steps_->add(step);
    if (parameters_.output.print_progress)
      log_->line(format("Step %u: t = %.6g certified", step.number, step.time) +
                 (surface.has_obstacles()
                    ? ", " + label("force on the body", units_.force) + " " +
                        format_vector("%.6g", step.force())
                    : ""));
    is_step_written_ = step.number % parameters_.output.every == 0 || times.is_finished();
    if (is_step_written_)
      write_step();
  }

  void ContactProblem::write_step()
  {
    compute_reactions();
    write_fields(steps_->tag());
    if (parameters_.output.write_solution)
      steps_->add_file("solution", "pvtu");
    steps_->add_file("contact", "pvtu");
    if (contact_surface().has_obstacles())
      steps_->add_file("obstacle", "vtu");
  }

  void ContactProblem::write_fields(const std::string &tag) const
  {
    const OutputParameters &output = parameters_.output;
    const LA::Vector &u            = state_.u;
    if (output.write_solution)
      write_solution(elasticity(), u, reactions_->nodal(),
                     refinement_ ? refinement_->indicators() : dealii::Vector<double>(),
                     output, tag);
    const std::vector<NodeStatus> statuses = node_statuses();
    write_contact(elasticity(), u, contact_surface(), *certificate_, statuses, output,
                  tag, steps_ ? state_.history.path : Eigen::VectorXd());
    if (output.double_precision)
      {
        write_nodal_displacement(output.directory, *body_, u, reactions_->nodal(), tag);
        write_contact_nodes(output.directory, contact_surface(), *certificate_, statuses,
                            communicator_, tag);
      }
    write_obstacles(output.directory, elasticity(), contact_surface(), state_, tag);
  }

  void ContactProblem::export_problem()
  {
    const std::string &directory = parameters_.output.export_directory;
    if (directory.empty() || (!discretization_->solver && !status_.converged))
      return; // a step that was refused has nothing to export
    const DualOperator &Q         = *solver().dual_operator();
    const auto phase              = phases_.scope("output");
    const ContactSurface &surface = contact_surface();
    const Eigen::MatrixXd G       = rigid_balance(elasticity(), surface).G;
    Eigen::VectorXd places(G.cols()); // of obstacles and body, as they are
    places << state_.distances, elasticity().free_motion_of(state_.u);
    do_on_first_rank(communicator_, [&]() {
      DualProblem problem;
      problem.Q          = *Q.matrix();
      problem.h          = Q.right_hand_side() - G.lazyProduct(places);
      problem.slip_bound = surface.slip_bound();
      problem.areas      = surface.areas();
      problem.positions.resize(surface.n_nodes(), 3);
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          problem.positions(i, c) = surface.nodes()[i].position[c];
      stiction::export_problem(directory, problem, surface.without_dragged(state_.lambda),
                               surface.without_dragged(certificate_->gradient()));
    });
  }

  RunResult ContactProblem::result() const
  {
    const ContactSurface &surface          = contact_surface();
    const std::vector<NodeStatus> statuses = node_statuses();
    RunResult result =
      result_of(status_, *certificate_, statuses, parameters_.contact_solver.tolerance,
                parameters_.output, phases_, communicator_);
    if (ends_between_steps_)
      result.reason = format("the steps to t = %.6g are certified, those after it were "
                             "not taken",
                             ends_.front().time);
    if (discretization_->solver)
      discretization_->solver->add_to(result);
    result.solver.law                      = parameters_.friction.name();
    result.solver.elastic_solve_iterations = elastic_solve_iterations_;
    if (elastic_solve_iterations_ > 0)
      result.solver.elastic_solve_equivalents =
        phases_.seconds("contact_solve") / phases_.seconds("elastic_solve");
    add_body(result, *body_, surface, state_, *certificate_, statuses, *reactions_,
             mesh_error_);
    for (RunResult::ContactPart &part : result.boundaries)
      if (const ContactBoundary &pair = surface.boundary(part.id);
          pair.partners().size() > 1)
        {
          const auto forces = forces_of_partners(elasticity(), surface, pair, state_);
          for (std::size_t p = 0; p < forces.size(); ++p)
            part.of_opposite.emplace_back(
              body_->boundary_names().name(pair.partners()[p]), forces[p]);
        }
    result.warnings = warnings();
    return result;
  }

  json ContactProblem::step_list() const
  {
    json list = steps_->to_json(
      elastic_solve_iterations_ > 0 ? phases_.seconds("elastic_solve") : 0.);
    if (!status_.converged && !ends_between_steps_)
      list.push_back({{"t", elasticity().time()},
                      {"certified", false},
                      {"residual", certificate_->worst_figure().second}});
    return list;
  }

  void ContactProblem::print_totals() const
  {
    const EnergyBalance::Step all = steps_->energy();
    log_->line(
      format("Certified steps: %zu, ", steps_->steps().size()) +
      label("work", units_.energy) +
      format(" of loads %.6g, supports %.6g, %s %.6g; dissipated %.6g, "
             "elastic energy %.6g, time stepping and initial interference %.6g.",
             all.loads, all.supports,
             contact_surface().has_obstacles() ? "obstacles" : "growing interference",
             all.obstacles, all.dissipation, all.elastic_energy, all.time_stepping));
  }

  std::string ContactProblem::files_to_open() const
  {
    const std::string ending = !steps_                ? ".pvtu"
                               : !steps_->has_files() ? "_uncertified.pvtu"
                                                      : ".pvd";
    const std::string start  = parameters_.output.directory + "/";
    return (parameters_.output.write_solution ? start + "solution" + ending + " and "
                                              : std::string()) +
           start + "contact" + ending + " in ParaView" +
           (ending == ".pvd" && !status_.converged && !ends_between_steps_
              ? "; what is not certified is in " + start + "contact_uncertified.pvtu"
              : "") +
           ".";
  }

  void ContactProblem::summarize(const RunResult &result)
  {
    summary_      = std::make_unique<json>(to_json(result, parameters_.contact_solver,
                                                   parameters_.output.units,
                                                   parameters_.source, communicator_));
    json &summary = *summary_;
    summary["problem"]     = {{"cells", body_->triangulation().n_global_active_cells()},
                              {"nodes", body_->n_nodes()},
                              {"dofs", body_->dof_handler().n_dofs()},
                              {"contact_nodes", contact_surface().n_nodes()},
                              {"dual_unknowns", 3 * contact_surface().n_nodes()},
                              {"free_motions", elasticity().free_motions().in_words()},
                              {"boundaries", json::array()}};
    const MeshNames &names = body_->boundary_names();
    for (const auto id : names.ids())
      summary["problem"]["boundaries"].push_back({{"id", id}, {"name", names.name(id)}});
    if (steps_)
      summary["steps"] = step_list();
    if (refinement_)
      summary["refinement"] = refinement_->to_json();
    write_summary(summary, parameters_.output.directory, communicator_);
  }

  void ContactProblem::report()
  {
    const RunResult result = this->result();
    summarize(result);
    print_report(*log_, result, parameters_.contact_solver.tolerance,
                 parameters_.performance.print_timing,
                 parameters_.stiffness_solver.type == "multigrid" &&
                     parameters_.geometry.element_degree == 2
                   ? "'Geometry/Global refinement' lowers it"
                 : refinement_ && refinement_->has_raised_error()
                   ? "refining has not lowered it, look where it is large "
                     "(error_indicator in the files) and where the pressure is"
                 : parameters_.refinement.adaptive_steps > 0
                   ? "more 'Refinement/Adaptive steps' lower it"
                   : "'Refinement/Adaptive steps' lowers it");
    if (steps_ && !steps_->steps().empty())
      print_totals();
    log_->line("Open " + files_to_open());
    if (!parameters_.output.export_directory.empty())
      log_->line("The discrete problem is in " + parameters_.output.export_directory +
                 ".");
  }
} // namespace stiction
