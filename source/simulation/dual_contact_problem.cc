#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/base/interrupt.h>
#include <stiction/base/log.h>
#include <stiction/contact/dual/dual_method_factory.h>
#include <stiction/output/problem/problem_check.h>
#include <stiction/output/problem/problem_files.h>
#include <stiction/output/results/convergence_history.h>
#include <stiction/output/results/output_directory.h>
#include <stiction/output/results/report.h>
#include <stiction/output/results/run_result.h>
#include <stiction/qp/advice.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/verifier.h>
#include <stiction/simulation/dual_contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>

#include <nlohmann/json.hpp>

#include <Eigen/Cholesky>

#include <utility>

namespace stiction
{
  namespace
  {
    // Throws InputError for numbers whose products leave the range of a
    // double, and for a Q that is indefinite by more than rounding.
    void require_solvable(const DualProblem &problem, const std::string &path)
    {
      constexpr double smallest = 1e-50, largest = 1e50;
      const auto require_size = [&](const Eigen::VectorXd &v, const char *name) {
        const double size = v.cwiseAbs().maxCoeff();
        if (size != 0. && !(size >= smallest && size <= largest))
          throw InputError(path + ": the largest entry of " + name + " is " +
                           format("%g", size) +
                           ", must be 0 or from 1e-50 to 1e50 in size: choose "
                           "other units.");
      };
      require_size(problem.Q.diagonal(), "the diagonal of Q");
      require_size(problem.h, "h");
      require_size(problem.slip_bound.data(), "the friction data");
      if (problem.areas.size() > 0 &&
          problem.areas.maxCoeff() > 1e10 * problem.areas.minCoeff())
        throw InputError(path + ": the largest area is " +
                         format("%g", problem.areas.maxCoeff()) +
                         ", must be at most 1e10 times the smallest.");

      // singular is allowed, if only just
      Eigen::MatrixXd shifted = problem.Q;
      shifted.diagonal() *= 1. + 1e-10;
      if (Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(shifted).info() != Eigen::Success)
        throw InputError(path + ": Q has a negative eigenvalue, must be "
                                "positive definite.");
    }
  } // namespace

  DualContactProblem::DualContactProblem(std::string path, const Parameters &parameters,
                                         MPI_Comm communicator)
    : path_(std::move(path))
    , parameters_(parameters)
    , communicator_(communicator)
    , log_(std::make_unique<Log>(communicator))
  {
    if (parameters.output.print_progress)
      phases_.announce(*log_);
  }

  DualContactProblem::~DualContactProblem() = default;

  bool DualContactProblem::run()
  {
    {
      const auto total = phases_.scope("total");
      read_problem();
      open_output_directory(parameters_.output, parameters_.source,
                            parameters_.used_file(), *log_, communicator_);
      keep_iterate_when_interrupted();
      solve_contact();
      output_results();
    }
    report();
    log_->close_file();
    return status_.converged;
  }

  void DualContactProblem::read_problem()
  {
    const auto phase = phases_.scope("reading");
    throw_on_all_ranks(communicator_, [&]() { // their files may differ
      problem_ = import_problem(path_, parameters_.dual_operator.symmetric_part);
    });
    parameters_.check_method(problem_.slip_bound.is_coulomb());
    parameters_.source.require(
      !parameters_.contact_solver.is_primal(), "Contact solver/Method",
      "works on a mesh, must be another one for a problem from a file");
    require_solvable(problem_, path_);
    Q_ =
      std::make_unique<DenseDualOperator>(std::move(problem_.Q), std::move(problem_.h));
    history_ = std::make_unique<ConvergenceHistory>(
      *log_, step_name(parameters_.contact_solver, problem_.slip_bound.is_coulomb()),
      false, parameters_.output.print_progress);
    log_->line(
      format("Problem: %lld contact nodes, %s", static_cast<long long>(Q_->n_nodes()),
             problem_.slip_bound.is_coulomb() ? "Coulomb friction" : "given friction"));
  }

  void DualContactProblem::solve_contact()
  {
    const auto whole = phases_.scope("contact_solve");
    const auto phase = phases_.scope("dual_iteration");
    method_          = create_dual_method(parameters_.contact_solver, *Q_,
                                          problem_.slip_bound.is_coulomb());
    verifier_ =
      std::make_unique<DualProblemVerifier>(*Q_, problem_.slip_bound, problem_.areas);
    status_ = certified_solve(
      *method_, *Q_, problem_.slip_bound, *verifier_,
      parameters_.contact_solver.tolerance, parameters_.contact_solver.maximum_iterations,
      parameters_.advice_on_method(problem_.slip_bound.is_coulomb(), false),
      [&](const ContactStep &step) {
        history_->add(step);
        stop_if_interrupted(communicator_);
      },
      lambda_);
    conditions_ = &verifier_->verify(lambda_);
  }

  std::vector<NodeStatus> DualContactProblem::node_statuses() const
  {
    return stiction::node_statuses(*conditions_, problem_.slip_bound,
                                   Q_->nodal_compliance().cwiseInverse(),
                                   parameters_.contact_solver.tolerance);
  }

  void DualContactProblem::output_results()
  {
    const auto phase             = phases_.scope("output");
    const std::string &directory = parameters_.output.directory;
    write_history(*history_, directory, communicator_);
    const std::vector<NodeStatus> statuses = node_statuses();
    do_on_first_rank(communicator_, [&]() {
      write_file(directory + "/forces.csv", [&](std::ostream &out) {
        const Eigen::Index m = Q_->n_nodes();
        const auto &lambda   = conditions_->lambda();
        const auto &r        = conditions_->gradient();
        out.precision(17);
        out << "node,lambda_n,lambda_t1,lambda_t2,gap,slip_t1,slip_t2,"
               "normal_status,tangential_status\n";
        for (Eigen::Index i = 0; i < m; ++i)
          out << i << ',' << lambda(i) << ',' << lambda(i + m) << ',' << lambda(i + 2 * m)
              << ',' << r(i) << ',' << 0. - r(i + m) << ',' << 0. - r(i + 2 * m) << ','
              << static_cast<int>(statuses[i].normal) << ','
              << static_cast<int>(statuses[i].tangential) << '\n';
      });
      if (!parameters_.output.export_directory.empty())
        {
          DualProblem problem = problem_;
          problem.Q           = *Q_->matrix();
          problem.h           = Q_->right_hand_side();
          export_problem(parameters_.output.export_directory, problem,
                         conditions_->lambda(), conditions_->gradient());
        }
    });
  }

  void DualContactProblem::report()
  {
    const qp::SlipBound &bound = problem_.slip_bound;
    RunResult result           = result_of(status_, *conditions_, node_statuses(),
                                           parameters_.contact_solver.tolerance, parameters_.output,
                                           phases_, communicator_);
    add_method(result.solver, method_->statistics(), *Q_);
    result.solver.law          = bound.is_mixed()               ? "mixed"
                                 : bound.is_coulomb()           ? "coulomb"
                                 : !bound.constant().isZero(0.) ? "given"
                                                                : "frictionless";
    const std::string friction = warning_on_friction(bound.largest_coefficient());
    if (result.converged && !friction.empty())
      result.warnings.push_back(friction);
    if (problem_.asymmetry > problem_check::symmetry)
      result.warnings.push_back(
        format("Q is the symmetric part of that of the file, where entries across the "
               "diagonal differ by up to %.2g of it; of the problem of the file itself "
               "the certificate says nothing.",
               problem_.asymmetry));

    summary_ = std::make_unique<nlohmann::json>(
      to_json(result, parameters_.contact_solver, parameters_.output.units,
              parameters_.source, communicator_));
    (*summary_)["problem"] = {{"file", path_},
                              {"contact_nodes", Q_->n_nodes()},
                              {"dual_unknowns", 3 * Q_->n_nodes()},
                              {"asymmetry", problem_.asymmetry}};
    write_summary(*summary_, parameters_.output.directory, communicator_);

    print_report(*log_, result, parameters_.contact_solver.tolerance,
                 parameters_.performance.print_timing);
    log_->line("There was no body to judge: the certificate is that of the "
               "contact conditions with Q and h as they are.");
    log_->line("The contact forces are in " + parameters_.output.directory +
               "/forces.csv.");
  }
} // namespace stiction
