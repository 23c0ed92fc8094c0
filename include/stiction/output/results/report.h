#pragma once

#include <string>

namespace stiction
{
  class ContactConditions;
  class Log;
  struct SolveStatus;
  struct ContactSolverParameters;
  struct RunResult;

  /// "  largest pressure [Pa]    1.2e+09"
  void print_row(Log &log, const std::string &name, const std::string &text);

  /// What an outermost iteration of the method is called.
  std::string step_name(const ContactSolverParameters &parameters, bool is_coulomb);

  /// Why a solution is not certified, "kkt_residual is 3e-4, the tolerance is
  /// 1e-6; ..." and what to change; empty if it is.
  std::string explain(const SolveStatus &solution, const ContactConditions &conditions,
                      double tolerance);

  /// The end of a run in words: contact state, forces, energies, the
  /// certificate with its verdict, if asked for what it cost, the estimated
  /// error of the mesh with what lowers it, and warnings.
  ///
  /// @param mesh_remedy "'Refinement/Adaptive steps' lowers it".
  void print_report(Log &log, const RunResult &result, double tolerance,
                    bool prints_costs, const std::string &mesh_remedy = "");
} // namespace stiction
