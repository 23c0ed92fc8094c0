#pragma once

#include <stiction/base/phases.h>
#include <stiction/qp/certified_solve.h>
#include <stiction/qp/dual_problem.h>

#include <nlohmann/json_fwd.hpp>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace stiction
{
  class ContactConditions;
  class ConvergenceHistory;
  class DualMethod;
  class DualOperator;
  class DualProblemVerifier;
  class Log;
  struct NodeStatus;
  class Parameters;

  /// A contact problem from a file with Q, h and the friction data, without a
  /// body: from the file to the certified contact forces. The certificate has
  /// the figures of the contact conditions only.
  ///
  /// Runs the same on every rank.
  class DualContactProblem
  {
  public:
    /// @param path see import_problem().
    /// @param parameters their sections on the contact solver and on output
    ///   count; must outlive the problem.
    DualContactProblem(std::string path, const Parameters &parameters,
                       MPI_Comm communicator);
    ~DualContactProblem();

    /// Solves the problem, judges the answer and writes forces.csv and the
    /// files that every run writes. Collective. Throws InputError.
    ///
    /// @return whether the tolerance was reached.
    bool run();

    /// The content of summary.json, after run().
    const nlohmann::json &summary() const { return *summary_; }

    const SolveStatus &status() const { return status_; }

  private:
    std::vector<NodeStatus> node_statuses() const;

    void read_problem();
    void solve_contact();
    void output_results();
    /// Writes summary.json and prints the report.
    void report();

    const std::string path_;
    const Parameters &parameters_;
    const MPI_Comm communicator_;

    std::unique_ptr<Log> log_;
    std::unique_ptr<ConvergenceHistory> history_;
    DualProblem problem_;
    std::unique_ptr<DualOperator> Q_;
    std::unique_ptr<DualMethod> method_;
    std::unique_ptr<DualProblemVerifier> verifier_;
    Eigen::VectorXd lambda_; ///< the answer, N
    SolveStatus status_;
    const ContactConditions *conditions_ = nullptr; ///< of the solution
    std::unique_ptr<nlohmann::json> summary_;
    Phases phases_;
  };
} // namespace stiction
