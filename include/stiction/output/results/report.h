#ifndef stiction_output_results_report_h
#define stiction_output_results_report_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace stiction
{
  class ContactConditions;
  class Log;
  class Parameters;
  struct SolveStatus;
  struct ContactSolverParameters;

  /// What an outermost iteration of the method is called.
  std::string step_name(const ContactSolverParameters &parameters, bool is_coulomb);

  /// Why a solution is not certified, "kkt_residual is 3e-4, the tolerance is
  /// 1e-6; ..." and what to change; empty if it is.
  std::string explain(const SolveStatus &solution, const ContactConditions &conditions,
                      double tolerance);

  /// A sentence on the estimated error of the mesh and what lowers it; empty if
  /// none was estimated.
  ///
  /// @param mesh_error the section of summary.json.
  std::string describe_mesh_error(const nlohmann::json &mesh_error,
                                  const Parameters &parameters);

  /// The end of a run in words: contact state, forces, energies, the
  /// certificate with its verdict, and if asked for what it cost.
  ///
  /// @param summary the content of summary.json.
  /// @param tolerance what the certificate had to reach.
  /// @param reason if it did not: see explain().
  void print_report(Log &log, const nlohmann::json &summary, double tolerance,
                    const std::string &reason, bool with_costs);
} // namespace stiction

#endif
