#ifndef stiction_output_report_h
#define stiction_output_report_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace stiction
{
  class Log;

  /// The end of a run in words: contact state, forces, energies, the
  /// certificate with its verdict, and if asked for what it cost.
  ///
  /// @param summary the content of summary.json.
  /// @param tolerance what the certificate had to reach.
  /// @param reason if it did not: what stopped the iteration.
  void
  print_report(Log &log,
               const nlohmann::json &summary,
               double tolerance,
               const std::string &reason,
               bool with_costs);
} // namespace stiction

#endif
