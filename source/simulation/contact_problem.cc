#include <stiction/base/errors.h>
#include <stiction/base/interrupt.h>
#include <stiction/base/log.h>
#include <stiction/base/text/in_words.h>
#include <stiction/contact/certificate/duality_gap.h>
#include <stiction/contact/dual/hardly_resisted.h>
#include <stiction/contact/dual/no_equilibrium.h>
#include <stiction/contact/dual/rigid_balance.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/local_refinement.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/support_reactions.h>
#include <stiction/output/history/step_history.h>
#include <stiction/output/results/convergence_history.h>
#include <stiction/output/results/output_directory.h>
#include <stiction/output/results/overview.h>
#include <stiction/output/results/report.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/simulation/adaptive_refinement.h>
#include <stiction/simulation/checkpoint/checkpoint.h>
#include <stiction/simulation/checkpoint/checkpoint_files.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/memory_estimates.h>
#include <stiction/simulation/parameters/missing_entries.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/reference_costs.h>
#include <stiction/simulation/time_steps.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace stiction
{
  using nlohmann::json;

  namespace
  {
    // Fewer are made in a second or two.
    constexpr double cells_worth_a_word = 2e5;

    // For formulas at the times of all steps, where nothing is solved.
    constexpr double seconds_for_times = 20.;

    // The last one, and then those between ever closer.
    std::vector<double> spread(const std::vector<double> &times)
    {
      const std::size_t n = times.size();
      std::size_t stride  = 1;
      while (stride < n)
        stride *= 2;
      std::vector<double> result{times.back()};
      for (; stride > 0; stride /= 2)
        for (std::size_t k = stride; k < n; k += 2 * stride)
          result.push_back(times[n - 1 - k]);
      return result;
    }
  } // namespace

  ContactProblem::ContactProblem(const Parameters &parameters, MPI_Comm communicator,
                                 const std::string &restart)
    : parameters_(parameters)
    , communicator_(communicator)
    , units_(Units::named(parameters.output.units))
    , log_(std::make_unique<Log>(communicator))
    , history_(std::make_unique<ConvergenceHistory>(
        *log_, step_name(parameters.contact_solver, parameters.friction.has_coulomb()),
        parameters.contact_solver.is_primal(), parameters.output.print_progress,
        parameters.refinement.adaptive_steps > 0,
        parameters.time.has_steps() || !restart.empty()))
  {
    if (!restart.empty())
      restart_ = std::make_unique<CheckpointReader>(restart, parameters, communicator);
    if (parameters.output.print_progress)
      phases_.announce(*log_);
    if (parameters.time.has_steps() || restart_)
      steps_ = std::make_unique<StepHistory>(parameters.output.directory, communicator);
  }

  ContactProblem::~ContactProblem() = default;

  bool ContactProblem::run()
  {
    TimeSteps times(parameters_.time.start, parameters_.time.times(),
                    parameters_.time.smallest_step);
    {
      const auto total = phases_.scope("total");
      make_grid();
      assemble_system();
      make_contact_surface();
      describe_applied();
      describe_gaps();
      require_writable_output(parameters_.output, parameters_.source, communicator_);
      go_on(times);
      begin_balance();
      while (!times.is_finished() && take_step(times))
        {
        }
      save(times);
      measure_duality_gap();
      estimate_mesh();
      if (!status_.interrupted)
        measure_reference_costs();
      output_results();
      export_problem();
    }
    report();
    explain_restart(times);
    log_->close_file();
    return status_.converged;
  }

  void ContactProblem::measure_duality_gap()
  {
    if (!state_.lambda.allFinite() || (status_.interrupted && !status_.converged))
      return; // the gap only informs, and takes an elastic solve
    if (elasticity().free_motions().n() > 0)
      return; // forces that are not balanced to the last digit bound nothing
    const auto phase = phases_.scope("certificate");
    try
      {
        certificate_->set_duality_gap(duality_gap(elasticity(), contact_surface(), state_,
                                                  solver().stiffness_solver()));
      }
    catch (const std::runtime_error &)
      {
        log_->line("The duality gap was not computed: its elastic solve did not "
                   "converge.");
      }
  }

  void ContactProblem::observe(const ContactStep &iteration)
  {
    history_->add(iteration);
    if (!iteration.remark.empty() && parameters_.output.print_progress)
      log_->line(iteration.remark);
    stop_if_interrupted(communicator_);
  }

  void ContactProblem::validate()
  {
    make_grid();
    assemble_system();
    make_contact_surface();
    require_writable_output(parameters_.output, parameters_.source, communicator_);
    describe_applied();
    describe_gaps();
    print_overview(*log_, elasticity(), contact_surface(), units_);
    print_memory(*log_, parameters_,
                 static_cast<double>(body_->triangulation().n_global_active_cells()),
                 static_cast<double>(elasticity().mesh().n_dofs()),
                 static_cast<double>(contact_surface().B().all_dofs().size()),
                 communicator_);
    check_times();
    log_->line("The input is valid; nothing was solved.");
  }

  void ContactProblem::check_times()
  {
    if (restart_)
      return; // the steps that were taken had other formulas
    std::vector<double> times = parameters_.time.times();
    if (steps_)
      times.insert(times.begin(), parameters_.time.start);
    const bool slides_far = contact_surface().slides_far();
    const dealii::Timer timer;
    std::size_t n_done = 0;
    for (const double time : spread(times))
      {
        if (dealii::Utilities::MPI::max(timer.wall_time(), communicator_) >
            seconds_for_times)
          return log_->line(text_of("Formulas were evaluated at ", n_done, " of ",
                                    times.size(),
                                    " times, all of them would take long."));
        if (slides_far) // obstacles are where answers put them
          discretization_->elasticity->set_time(time);
        else
          discretization_->set_time(parameters_.of_contact(), time, {});
        ++n_done;
      }
    if (slides_far)
      log_->line("With 'Sliding = far' formulas of obstacles and friction were evaluated "
                 "at the first time alone.");
  }

  void ContactProblem::make_grid()
  {
    const auto phase = phases_.scope("mesh");
    describe_machine();
    bool is_said          = false; // the size of a file is known later
    const auto check_size = [&](const double n_cells) {
      require_memory_for_mesh(parameters_, n_cells, communicator_);
      if (n_cells > cells_worth_a_word && !is_said)
        log_->line(format("Making a mesh of about %.3g cells; the run will "
                          "take some %.2g GB of memory",
                          n_cells, memory_for_mesh(parameters_, n_cells) / 1e9));
      is_said = is_said || n_cells > cells_worth_a_word;
    };
    check_size(parameters_.geometry.n_cells());
    body_ = std::make_unique<Body>(parameters_.geometry, communicator_, check_size);
    require_complete(parameters_, body_->boundary_names());
    assign_material_ids(*body_, parameters_.of_body());
    refine_contact_boundary(*body_, parameters_.geometry,
                            parameters_.contact.all_boundaries(), parameters_.source);
    if (restart_)
      {
        mesh_history_ = restart_->mesh();
        mesh_history_.repeat_on(*body_);
      }
    describe_body();
    describe_choices();
  }

  void ContactProblem::assemble_system()
  {
    const auto phase = phases_.scope("assembly");
    discretization_  = std::make_unique<Discretization>();
    discretization_->elasticity =
      std::make_unique<LinearElasticity>(*body_, parameters_.of_body());
  }

  void ContactProblem::make_contact_surface()
  {
    const auto phase = phases_.scope("contact_surface");
    discretization_->surface =
      std::make_unique<ContactSurface>(elasticity(), parameters_.of_contact());
    discretization_->elasticity->choose_anchors(contact_surface().first_dofs());
    require_load(parameters_, body_->boundary_names(), contact_surface());
    const std::string law = parameters_.friction.name();
    require_memory_for_dual_operator(
      parameters_, static_cast<double>(contact_surface().B().all_dofs().size()),
      communicator_);
    const Eigen::Index m = contact_surface().n_nodes();
    log_->line(text_of("Contact: ", m, " nodes, ", 3 * m, " dual unknowns, ",
                       law == "coulomb" ? "Coulomb friction"
                       : law == "given" ? "given friction"
                       : law == "mixed" ? "several laws of friction"
                       : law == "tied"  ? "tied"
                                        : "no friction"));
    if (const std::string loose = why_loose(elasticity(), contact_surface());
        !loose.empty())
      throw InputError(parameters_.geometry.location + ": " + loose + ".");
    describe_touching_bodies();
    const Eigen::MatrixXd unresisted =
      unresisted_motions(elasticity(), contact_surface());
    if (unresisted.cols() > 0)
      log_->line("  nothing resists where the body can " +
                 elasticity().free_motions().in_words(unresisted) +
                 ": there it is left where it is");
    if (const std::string motion = hardly_resisted(); !motion.empty())
      log_->line("  hardly anything resists where the body can " + motion);
    if (!steps_)
      if (const std::string reason =
            why_no_equilibrium(elasticity(), contact_surface(), units_);
          !reason.empty())
        throw InputError(parameters_.source.file() + ": " + reason +
                         "; change the loads, or hold the body with 'Boundary "
                         "conditions/Prescribed displacement'.");
    if (contact_surface().n_facing_away() > 0)
      log_->line(text_of("  ", contact_surface().n_facing_away(),
                         " nodes face away from the obstacle and are none"));
    if (parameters_.output.export_directory.empty())
      return;
    const std::string entry = "Output/Export directory";
    parameters_.source.require(
      !contact_surface().slip_bound().has_tied(), entry,
      "problem files know no tied nodes, so 'Friction/Law' must not have 'tied'");
    parameters_.source.require(
      !contact_surface().slip_bound().is_mixed(), entry,
      "problem files know one law of friction for all nodes, so 'Friction/Law' must not "
      "have both 'given' and 'coulomb'");
  }

  void ContactProblem::open_output()
  {
    if (has_output_)
      return; // since an earlier mesh
    has_output_           = true;
    const bool is_resumed = goes_on_in_place();
    open_output_directory(parameters_.output, parameters_.source, parameters_.used_file(),
                          *log_, communicator_, is_resumed);
    if (!is_resumed)
      do_on_first_rank(communicator_,
                       [&]() { checkpoint_files::remove(parameters_.output.directory); });
    keep_iterate_when_interrupted();
  }

  void ContactProblem::estimate_mesh()
  {
    constexpr double released = 1e-12; // of the energy of a history: less is rounding
    if (refinement_)
      mesh_error_ = refinement_->mesh_error();
    else if (parameters_.refinement.estimate_error && status_.converged &&
             !certificate_->bears_nothing() &&
             2. * certificate_->strain_energy() >= released * state_.scales.energy)
      {
        const auto phase = phases_.scope("error_estimate");
        try
          {
            mesh_error_ = estimate_mesh_error(elasticity(), contact_surface(), state_);
          }
        catch (const InputError &error)
          {
            log_->line(std::string("The error of the mesh was not estimated: ") +
                       error.what());
          }
      }
  }

  void ContactProblem::measure_reference_costs()
  {
    const auto phase = phases_.scope("yardsticks");
    if (parameters_.performance.measure_one_elastic_solve)
      {
        const ElasticSolveCost cost = measure_elastic_solve(elasticity(), contact_force(),
                                                            parameters_.is_matrix_free());
        elastic_solve_iterations_   = cost.iterations;
        phases_.set("elastic_solve", cost.seconds);
        phases_.set("elastic_solve_iteration", cost.seconds_of_iteration);
      }
    if (parameters_.performance.measure_factorizations && discretization_->solver)
      {
        const DualOperator *const Q = discretization_->solver->dual_operator();
        const FactorizationCost cost =
          measure_factorizations(elasticity(), Q != nullptr ? Q->matrix() : nullptr);
        phases_.set("sparse_factorization", cost.sparse_seconds);
        if (cost.dense_seconds > 0.)
          phases_.set("dual_cholesky", cost.dense_seconds);
      }
  }
} // namespace stiction
