#include <stiction/output/log.h>
#include <stiction/output/report.h>

#include <nlohmann/json.hpp>

#include <array>

namespace stiction
{
  namespace
  {
    using nlohmann::json;

    std::string
    vector_line(const char *name, const json &v)
    {
      return format("  %-24s %.6g, %.6g, %.6g",
                    name,
                    v[0].get<double>(),
                    v[1].get<double>(),
                    v[2].get<double>());
    }

    std::string
    number(const json &value)
    {
      return value.is_null() ? std::string("not measured")
                             : format("%.4g", value.get<double>());
    }
  } // namespace



  void
  print_report(Log &log,
               const json &summary,
               const double tolerance,
               const std::string &reason,
               const bool with_costs)
  {
    const json &contact = summary["contact"];
    log.line();
    log.line("Contact");
    log.line(format("  %-24s open %u, slip %u, stick %u (undecided %u)",
                    "nodes",
                    contact["open"].get<unsigned int>(),
                    contact["slip"].get<unsigned int>(),
                    contact["stick"].get<unsigned int>(),
                    contact["undecided"].get<unsigned int>()));
    log.line(vector_line("force on the body [N]", contact["force_on_body"]));
    log.line(format("  %-24s %.6g",
                    "largest pressure [Pa]",
                    contact["max_pressure"].get<double>()));
    log.line(format("  %-24s %.6g",
                    "largest displacement [m]",
                    summary["displacement"]["max"].get<double>()));
    log.line(format("  %-24s strain %.6g, load %.6g, friction %.6g",
                    "energy [J]",
                    summary["energy"]["strain"].get<double>(),
                    summary["energy"]["load_work"].get<double>(),
                    summary["energy"]["friction_dissipation"].get<double>()));

    log.line();
    log.line(format("Certificate (tolerance %g)", tolerance));
    const json &figures = summary["certificate"];
    struct Row
    {
      const char *name, *meaning;
      bool decides;
    };
    static const std::array<Row, 9> rows = {
      {{"equilibrium_residual", "forces in balance at every node", true},
       {"kkt_residual", "contact and friction conditions", true},
       {"penetration", "depth below the foundation", true},
       {"complementarity", "pressure across an open gap", true},
       {"cone_violation", "friction above its bound", true},
       {"force_balance", "forces in balance as a whole", true},
       {"moment_balance", "moments in balance as a whole", true},
       {"slip_angle", "degrees between friction and slip", false},
       {"duality_gap", "bound on the relative energy error", false}}};
    for (const Row &row : rows)
      {
        const double value = figures[row.name].get<double>();
        log.line(format("  %-24s %9.2e  %-36s %s",
                        row.name,
                        value,
                        row.meaning,
                        !row.decides         ? ""
                        : value <= tolerance ? "ok"
                                             : "NOT REACHED"));
      }
    if (summary["solver"]["law"] == "coulomb")
      log.line(
        "  (the duality gap is that of the last slip bound, held fixed)");

    if (with_costs)
      {
        const json &solver = summary["solver"], &seconds = summary["seconds"];
        log.line();
        log.line("Cost");
        log.line(format("  %-24s Coulomb steps %u, Gauss-Seidel sweeps %u",
                        "iterations",
                        solver["coulomb_iterations"].get<unsigned int>(),
                        solver["gauss_seidel_iterations"].get<unsigned int>()));
        log.line(format("  %-24s %.1f",
                        "products with Q",
                        solver["dual_multiplications"].get<double>()));
        log.line(format("  %-24s %u (%u Krylov iterations)",
                        "solves with K",
                        solver["stiffness_solves"].get<unsigned int>(),
                        solver["krylov_iterations"].get<unsigned int>()));
        log.line("  " + format("%-24s ", "elastic solves' worth") +
                 number(solver["elastic_solve_equivalents"]));
        std::string phases;
        for (const auto &phase : seconds.items())
          if (!phase.value().is_null())
            phases += (phases.empty() ? "" : ", ") + phase.key() +
                      format(" %.2f", phase.value().get<double>());
        log.line(format("  %-24s ", "seconds") + phases);
        log.line(format("  %-24s %.0f",
                        "peak memory [MB]",
                        summary["peak_memory_MB"].get<double>()));
      }

    log.line();
    if (summary["converged"].get<bool>())
      log.line("CERTIFIED: every deciding figure is within the tolerance.");
    else
      log.line("NOT CONVERGED: " + reason + ".");
  }
} // namespace stiction
