#include <stiction/contact/contact_surface.h>
#include <stiction/contact/gauss_seidel.h>
#include <stiction/contact/schur_complement.h>
#include <stiction/contact_problem.h>
#include <stiction/elasticity/amg_solver.h>
#include <stiction/elasticity/body.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/stiffness_solver.h>
#include <stiction/errors.h>
#include <stiction/memory.h>
#include <stiction/output/convergence_history.h>
#include <stiction/output/files.h>
#include <stiction/output/log.h>
#include <stiction/output/summary.h>
#include <stiction/output/vtu.h>
#include <stiction/output/report.h>
#include <stiction/parameters.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/trilinos_vector.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

namespace stiction
{
  namespace
  {
    using nlohmann::json;

    /// Adds the wall time of its scope to a phase.
    class Phase
    {
    public:
      Phase(std::map<std::string, double> &seconds, const std::string &name)
        : seconds_(seconds[name])
        , begin_(std::chrono::steady_clock::now())
      {
      }
      ~Phase()
      {
        seconds_ += std::chrono::duration<double>(
                      std::chrono::steady_clock::now() - begin_)
                      .count();
      }
      Phase(const Phase &) = delete;
      Phase &
      operator=(const Phase &) = delete;

    private:
      double &seconds_;
      const std::chrono::steady_clock::time_point begin_;
    };

    // An iterative solver stops here, far enough below the tolerance that the
    // certificate does not see it.
    constexpr double linear_solver_safety = 1e-4;
  } // namespace



  ContactProblem::ContactProblem(const Parameters &parameters,
                                 MPI_Comm communicator)
    : parameters_(parameters)
    , communicator_(communicator)
    , log_(std::make_unique<Log>(communicator))
    , history_(std::make_unique<ConvergenceHistory>(
        *log_,
        parameters.friction.law() == FrictionLaw::coulomb ? "Coulomb step"
                                                          : "sweep",
        parameters.output.print_progress))
  {
  }



  ContactProblem::~ContactProblem() = default;



  bool
  ContactProblem::run()
  {
    {
      const Phase total(seconds_, "total");
      make_grid();
      assemble_system();
      make_contact_surface();
      open_output();
      {
        const Phase contact_solve(seconds_, "contact_solve");
        set_up_stiffness_solver();
        set_up_dual_operator();
        solve_contact();
      }
      certify();
      measure_one_elastic_solve();
      output_results();
    }
    summarize();
    report();
    return solution_->converged;
  }



  void
  ContactProblem::validate()
  {
    make_grid();
    assemble_system();
    make_contact_surface();
    together(communicator_, [&]() {
      if (dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
        require_writable(parameters_.output.directory,
                         parameters_.source.describe("Output/Directory"));
    });
    log_->line("The input is valid; nothing was solved.");
  }



  void
  ContactProblem::make_grid()
  {
    const Phase phase(seconds_, "mesh");
    if (parameters_.performance.print_timing)
      log_->line(format(
        "stiction %s (deal.II %s, %s, %u rank%s)",
        STICTION_VERSION,
        DEAL_II_PACKAGE_VERSION,
        STICTION_BUILD_TYPE,
        dealii::Utilities::MPI::n_mpi_processes(communicator_),
        dealii::Utilities::MPI::n_mpi_processes(communicator_) == 1 ? ""
                                                                    : "s"));
    require_memory_for_mesh();
    body_ = std::make_unique<Body>(parameters_.geometry, communicator_);
    log_->line(
      format("Body: %llu cells, %llu nodes, %llu unknowns",
             static_cast<unsigned long long>(
               body_->triangulation().n_global_active_cells()),
             static_cast<unsigned long long>(body_->n_nodes()),
             static_cast<unsigned long long>(body_->dof_handler().n_dofs())));
  }



  void
  ContactProblem::assemble_system()
  {
    const Phase phase(seconds_, "assembly");
    elasticity_ = std::make_unique<LinearElasticity>(*body_, parameters_);
  }



  void
  ContactProblem::make_contact_surface()
  {
    const Phase phase(seconds_, "mesh");
    surface_ = std::make_unique<ContactSurface>(*elasticity_, parameters_);
    elasticity_->require_support();
    require_memory_for_dual_operator();
    log_->line(format("Contact: %lld nodes, %lld dual unknowns, %s",
                      static_cast<long long>(surface_->n_nodes()),
                      static_cast<long long>(3 * surface_->n_nodes()),
                      surface_->law() == FrictionLaw::coulomb
                        ? "Coulomb friction"
                      : surface_->law() == FrictionLaw::given ? "given friction"
                                                              : "no friction"));
  }



  void
  ContactProblem::require_memory_for_mesh() const
  {
    // two stiffness matrices of up to 81 × 3 entries a node, mesh, unknowns
    constexpr double bytes_per_cell = 8e3;

    const auto &geometry = parameters_.geometry;
    double cells         = std::pow(8., geometry.global_refinement);
    for (const unsigned int n : geometry.subdivisions)
      cells *= n;
    const double available = available_memory(communicator_);
    if (cells * bytes_per_cell > available)
      throw InputError(
        parameters_.source.describe(
          geometry.table_1_level > 0       ? "Geometry/Table 1 level"
          : geometry.global_refinement > 0 ? "Geometry/Global refinement"
                                           : "Geometry/Subdivisions") +
        format(", makes %.3g cells that need about %.3g GB of memory, at most "
               "%.3g GB are here.",
               cells,
               cells * bytes_per_cell / 1e9,
               available / 1e9));
  }



  void
  ContactProblem::require_memory_for_dual_operator() const
  {
    if (parameters_.dual_operator.form != "assembled")
      return;
    // Q on every rank, and on the first one the Schur complement and a copy
    const double n = 3. * static_cast<double>(surface_->n_nodes());
    const double bytes =
      8. * n * n *
      (dealii::Utilities::MPI::n_mpi_processes(communicator_) + 2.);
    const double available = available_memory(communicator_);
    if (bytes > available)
      throw InputError(parameters_.source.describe("Dual operator/Form") +
                       format(", needs %.3g GB of memory for %.0f dual "
                              "unknowns, at most %.3g GB are here, must be "
                              "'by solves' for a mesh as fine as this.",
                              bytes / 1e9,
                              n,
                              available / 1e9));
  }



  void
  ContactProblem::open_output()
  {
    const std::string &directory = parameters_.output.directory;
    together(communicator_, [&]() {
      if (dealii::Utilities::MPI::this_mpi_process(communicator_) != 0)
        return;
      const std::string entry = parameters_.source.describe("Output/Directory");
      require_writable(directory, entry);
      std::error_code error;
      std::filesystem::create_directories(directory, error);
      require_writable(directory + "/.", entry);
      log_->open_file(directory + "/log.txt");
      // an earlier success must not stand beside a later failure
      std::filesystem::remove(directory + "/summary.json", error);
    });
  }



  void
  ContactProblem::set_up_stiffness_solver()
  {
    const Phase phase(seconds_, "stiffness_setup");
    stiffness_solver_ = StiffnessSolver::create(
      parameters_.stiffness_solver,
      *elasticity_,
      linear_solver_safety * parameters_.contact_solver.tolerance);
  }



  void
  ContactProblem::set_up_dual_operator()
  {
    const Phase phase(seconds_, "dual_operator");
    if (parameters_.output.print_progress)
      log_->line("Dual operator: " + parameters_.dual_operator.form + ", " +
                 parameters_.stiffness_solver.type);
    schur_ = SchurComplement::create(parameters_.dual_operator.form,
                                     *elasticity_,
                                     *surface_,
                                     *stiffness_solver_);
  }



  void
  ContactProblem::solve_contact()
  {
    GaussSeidel gauss_seidel(*schur_);
    CoulombFixedPoint solver(*elasticity_,
                             *surface_,
                             *schur_,
                             *stiffness_solver_,
                             gauss_seidel,
                             parameters_.contact_solver);
    solution_ = std::make_unique<ContactSolution>(
      solver.solve([&](const ContactStep &step) { history_->add(step); }));
  }



  void
  ContactProblem::certify()
  {
    // the other figures were computed when the iteration asked for them
    solution_->certificate->compute_duality_gap(*solution_->u,
                                                *stiffness_solver_);
    if (!solution_->converged)
      solution_->reason = format("%s, the tolerance is %g; ",
                                 solution_->certificate->worst().c_str(),
                                 parameters_.contact_solver.tolerance) +
                          solution_->reason;
  }



  void
  ContactProblem::measure_one_elastic_solve()
  {
    if (!parameters_.performance.measure_one_elastic_solve)
      return;
    // The body with its contact boundary free, to a fixed accuracy, by a
    // method that needs no more memory than the matrix: the yardstick. The
    // better of two, because machines are noisy.
    double best = 0.;
    for (unsigned int run = 0; run < 2; ++run)
      {
        std::map<std::string, double> seconds;
        {
          const Phase phase(seconds, "elastic_solve");
          AmgSolver solver(*elasticity_, 1e-8);
          LA::Vector u = elasticity_->zero_vector();
          solver.solve(u, elasticity_->constrained_load());
          elastic_solve_iterations_ =
            static_cast<unsigned int>(solver.n_iterations());
        }
        best = run == 0 ? seconds["elastic_solve"]
                        : std::min(best, seconds["elastic_solve"]);
      }
    seconds_["elastic_solve"] = best;
  }



  void
  ContactProblem::output_results()
  {
    const Phase phase(seconds_, "output");
    const std::string &directory = parameters_.output.directory;
    write_solution(directory, *elasticity_, *solution_->u);
    write_contact(directory, *elasticity_, *surface_, *solution_->certificate);
    together(communicator_, [&]() {
      if (dealii::Utilities::MPI::this_mpi_process(communicator_) != 0)
        return;
      write_file(directory + "/convergence.csv",
                 [&](std::ostream &out) { history_->write(out); });
      write_file(directory + "/used_parameters.prm",
                 [&](std::ostream &out) { out << parameters_.used_file(); });
    });
  }



  void
  ContactProblem::summarize()
  {
    const auto second = [&](const char *phase) -> json {
      const auto entry = seconds_.find(phase);
      return entry == seconds_.end() ? json(nullptr) : json(entry->second);
    };
    const bool measured = elastic_solve_iterations_ > 0;

    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);

    summary_           = std::make_unique<json>();
    json &summary      = *summary_;
    summary["program"] = {
      {"name", "stiction"},
      {"version", STICTION_VERSION},
      {"dealii", DEAL_II_PACKAGE_VERSION},
      {"build_type", STICTION_BUILD_TYPE},
      {"ranks", dealii::Utilities::MPI::n_mpi_processes(communicator_)}};
    summary["converged"] = solution_->converged;
    summary["problem"]   = {
        {"cells", body_->triangulation().n_global_active_cells()},
        {"nodes", body_->n_nodes()},
        {"dofs", body_->dof_handler().n_dofs()},
        {"contact_nodes", surface_->n_nodes()},
        {"dual_unknowns", 3 * surface_->n_nodes()}};
    summary["solver"] = {
      {"law", parameters_.friction.law_name},
      {"method", parameters_.contact_solver.method},
      {"coulomb_iterations", solution_->coulomb_iterations},
      {"gauss_seidel_iterations", solution_->sweeps},
      {"newton_steps", 0},
      {"dual_multiplications", schur_->n_multiplications()},
      {"stiffness_solves", stiffness_solver_->n_solves()},
      {"krylov_iterations", stiffness_solver_->n_iterations()},
      {"elastic_solve_iterations",
       measured ? json(elastic_solve_iterations_) : json(nullptr)},
      {"elastic_solve_equivalents",
       measured
         ? json(seconds_.at("contact_solve") / seconds_.at("elastic_solve"))
         : json(nullptr)}};
    summary["certificate"] = certificate_to_json(*solution_->certificate);
    summary["contact"]     = contact_to_json(
      *surface_, *solution_->certificate, parameters_.contact_solver.tolerance);
    summary["displacement"] = displacement_to_json(*elasticity_, *solution_->u);
    summary["energy"] = energy_to_json(*surface_, *solution_->certificate);
    for (const char *phase : {"mesh",
                              "assembly",
                              "stiffness_setup",
                              "dual_operator",
                              "contact_solve",
                              "elastic_solve",
                              "output",
                              "total"})
      summary["seconds"][phase] = second(phase);
    summary["peak_memory_MB"] = dealii::Utilities::MPI::sum(
      static_cast<double>(memory.VmHWM) / 1024., communicator_);

    together(communicator_, [&]() {
      if (dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
        write_file(parameters_.output.directory + "/summary.json",
                   [&](std::ostream &out) { out << summary.dump(2) << '\n'; });
    });
  }



  void
  ContactProblem::report() const
  {
    const std::string &directory = parameters_.output.directory;
    print_report(*log_,
                 *summary_,
                 parameters_.contact_solver.tolerance,
                 solution_->reason,
                 parameters_.performance.print_timing);
    log_->line("Open " + directory + "/solution.pvtu and " + directory +
               "/contact.pvtu in ParaView.");
  }
} // namespace stiction
