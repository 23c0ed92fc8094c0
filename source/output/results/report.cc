#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/output/results/report.h>
#include <stiction/parameters/parameters.h>
#include <stiction/qp/certified_solve.h>
#include <stiction/qp/contact_conditions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stiction
{
  namespace
  {
    using nlohmann::json;

    std::string vector_text(const json &v)
    {
      return format_vector("%.6g", v.get<std::array<double, 3>>());
    }

    std::string vector_line(const std::string &name, const json &v)
    {
      return format("  %-24s ", name.c_str()) + vector_text(v);
    }

    // A force or moment in one line; what is rounding beside @p scale is zero.
    std::string resultant(const json &v, const double scale)
    {
      std::string text;
      for (const json &component : v)
        {
          const double value = component.get<double>();
          text += format("%s%.6g", text.empty() ? "" : ", ",
                         std::abs(value) > 1e-9 * scale ? value : 0.);
        }
      return text;
    }

    double largest_component(const json &v)
    {
      double largest = 0.;
      for (const json &component : v)
        largest = std::max(largest, std::abs(component.get<double>()));
      return largest;
    }

    // What holds the body, with which force and moment about the origin.
    void print_supports(Log &log, const json &summary)
    {
      const json &reactions = summary["reactions"];
      const json &units     = summary["units"];
      double force          = largest_component(summary["contact"]["force_on_body"]);
      double moment         = largest_component(summary["contact"]["moment"]);
      for (const json &boundary : reactions["boundaries"])
        {
          force  = std::max(force, largest_component(boundary["force"]));
          moment = std::max(moment, largest_component(boundary["moment"]));
        }
      for (const json &point : reactions["points"])
        force = std::max(force, largest_component(point["force"]));

      log.line();
      log.line(label("Supports: force", units["force"]) +
               label(" on the body, moment about the origin", units["moment"]));
      for (const json &boundary : reactions["boundaries"])
        {
          log.line(
            format("  %-24s force  ", boundary["name"].get<std::string>().c_str()) +
            resultant(boundary["force"], force));
          log.line(format("  %-24s moment ", "") + resultant(boundary["moment"], moment));
        }
      for (const json &point : reactions["points"])
        log.line(
          format("  %-24s force  ", ("point " + vector_text(point["at"])).c_str()) +
          resultant(point["force"], force));
    }

    // "open 25, closed 155 (undecided 0)"
    std::string normal_counts(const json &contact)
    {
      return format("open %u, closed %u (undecided %u)",
                    contact["open"].get<unsigned int>(),
                    contact["closed"].get<unsigned int>(),
                    contact["undecided_normal"].get<unsigned int>());
    }

    // "slip 120, stick 35 (undecided 0)", nothing where no friction can act
    std::string tangential_counts(const json &contact)
    {
      const auto slip      = contact["slip"].get<unsigned int>(),
                 stick     = contact["stick"].get<unsigned int>(),
                 undecided = contact["undecided_tangential"].get<unsigned int>();
      return slip + stick + undecided == 0
               ? std::string()
               : format("slip %u, stick %u (undecided %u)", slip, stick, undecided);
    }

    // The parts of several contact boundaries.
    void print_contact_boundaries(Log &log, const json &summary)
    {
      const json &units   = summary["units"];
      const json &contact = summary["contact"];
      double force = 0., moment = 0.;
      for (const json &boundary : contact["boundaries"])
        {
          force  = std::max(force, largest_component(boundary["force_on_body"]));
          moment = std::max(moment, largest_component(boundary["moment"]));
        }
      const auto line = [&](const std::string &name, const std::string &text) {
        log.line(format("  %-24s ", ("  " + name).c_str()) + text);
      };
      for (const json &boundary : contact["boundaries"])
        {
          const std::string friction = tangential_counts(boundary);
          log.line("  " + boundary["name"].get<std::string>() + ": " +
                   normal_counts(boundary) + (friction.empty() ? "" : "; " + friction));
          line(label("force on the body", units["force"]),
               resultant(boundary["force_on_body"], force));
          line(label("tangential", units["force"]),
               resultant(boundary["tangential_force"], force));
          line(label("moment", units["moment"]), resultant(boundary["moment"], moment));
          line(label("largest pressure", units["stress"]),
               format("%.6g", boundary["max_pressure"].get<double>()));
        }
    }

    std::string number(const json &value)
    {
      return value.is_null() ? std::string("not measured")
                             : format("%.4g", value.get<double>());
    }

    // the iterations that the method made, by name
    std::string iterations(const json &solver)
    {
      std::string all;
      for (const auto &count :
           {std::make_pair("coulomb_iterations", "Coulomb steps"),
            std::make_pair("gauss_seidel_iterations", "Gauss-Seidel sweeps"),
            std::make_pair("newton_steps", "Newton steps"),
            std::make_pair("krylov_iterations", "Krylov iterations"),
            std::make_pair("interior_point_steps", "interior point steps"),
            std::make_pair("conjugate_gradient_steps", "CG steps"),
            std::make_pair("expansion_steps", "expansions"),
            std::make_pair("release_steps", "releases"),
            std::make_pair("admm_iterations", "ADMM iterations"),
            std::make_pair("dense_factorizations", "dense factorizations"),
            std::make_pair("fallbacks", "fallbacks")})
        if (solver.value(count.first, 0u) > 0)
          all += (all.empty() ? "" : ", ") + std::string(count.second) +
                 format(" %u", solver.value(count.first, 0u));
      return all.empty() ? "none" : all;
    }

    // Figures are relative: below the precision of numbers they are nothing.
    constexpr double rounding_of_figures = 1e-16;

    // Parts of the energy norm: an error below the one is no matter of advice,
    // above the other nothing local is right.
    constexpr double small_mesh_error = 0.01, large_mesh_error = 0.3;

    // A geometric mean above this deserves a word.
    constexpr double worrying_contraction = 0.9;

    void print_contact(Log &log, const json &summary)
    {
      const json &contact = summary["contact"];
      log.line();
      log.line("Contact");
      log.line(format("  %-24s ", "nodes") + normal_counts(contact));
      if (const std::string friction = tangential_counts(contact); !friction.empty())
        log.line(format("  %-24s ", "nodes with friction") + friction);
      if (contact.contains("force_on_body"))
        {
          const json &units = summary["units"];
          log.line(vector_line(label("force on the body", units["force"]),
                               contact["force_on_body"]));
          for (const json &boundary : contact["boundaries"])
            if (boundary["obstacle_displacement"] != json({0., 0., 0.}))
              log.line(vector_line(contact["boundaries"].size() == 1
                                     ? label("obstacle moved by", units["length"])
                                     : label("moved", units["length"]) + ", " +
                                         boundary["name"].get<std::string>(),
                                   boundary["obstacle_displacement"]));
          log.line(format("  %-24s %.6g",
                          label("largest pressure", units["stress"]).c_str(),
                          contact["max_pressure"].get<double>()));
          log.line(format("  %-24s %.6g",
                          label("largest displacement", units["length"]).c_str(),
                          summary["displacement"]["max"].get<double>()));
          const auto energies =
            without_rounding({{summary["energy"]["strain"].get<double>(),
                               summary["energy"]["load_work"].get<double>(),
                               summary["energy"]["friction_dissipation"].get<double>()}});
          log.line(format("  %-24s strain %.6g, load %.6g, friction %.6g",
                          label("energy", units["energy"]).c_str(), energies[0],
                          energies[1], energies[2]));
          if (contact["boundaries"].size() > 1)
            print_contact_boundaries(log, summary);
          print_supports(log, summary);
        }
    }

    void print_certificate(Log &log, const json &summary, const double tolerance)
    {
      log.line();
      log.line(format("Certificate (tolerance %g)", tolerance));
      const json &figures = summary["certificate"];
      struct Row
      {
        const char *name, *meaning;
        bool decides;
      };
      static const std::array<Row, 10> rows = {
        {{"equilibrium_residual", "forces in balance at every node", true},
         {"kkt_residual", "contact and friction conditions", true},
         {"penetration", "depth below the foundation", true},
         {"complementarity", "pressure across an open gap", true},
         {"cone_violation", "friction above its bound", true},
         {"force_balance", "forces in balance as a whole", true},
         {"moment_balance", "moments in balance as a whole", true},
         {"obstacle_force", "obstacles press with their forces", true},
         {"slip_angle", "degrees between friction and slip", false},
         {"duality_gap", "bound on the relative energy error", false}}};
      for (const Row &row : rows)
        {
          if (figures[row.name].is_null())
            continue;
          double value = figures[row.name].get<double>();
          if (value < rounding_of_figures)
            value = 0.;
          log.line(format("  %-24s %9.2e  %-36s %s", row.name, value, row.meaning,
                          !row.decides         ? ""
                          : value <= tolerance ? "ok"
                                               : "NOT REACHED"));
        }
      if ((summary["solver"]["law"] == "coulomb" ||
           summary["solver"]["law"] == "mixed") &&
          !figures["duality_gap"].is_null())
        log.line("  (the duality gap is that of the last slip bound, held fixed)");
    }

    void print_costs(Log &log, const json &summary)
    {
      const json &solver = summary["solver"], &seconds = summary["seconds"];
      log.line();
      log.line("Cost");
      log.line("  " + format("%-24s ", "iterations") + iterations(solver));
      if (solver.contains("levels"))
        log.line(format("  %-24s %u Krylov iterations", "on coarser meshes",
                        solver["coarse_krylov_iterations"].get<unsigned int>()));
      else
        log.line(format("  %-24s %lu", "products with Q",
                        solver["dual_multiplications"].get<unsigned long>()));
      if (solver.contains("stiffness_solves") && !solver.contains("levels"))
        log.line(format("  %-24s %u (%u Krylov iterations)", "solves with K",
                        solver["stiffness_solves"].get<unsigned int>(),
                        solver["stiffness_krylov_iterations"].get<unsigned int>()));
      if (solver.contains("elastic_solve_equivalents"))
        log.line("  " + format("%-24s ", "elastic solves' worth") +
                 number(solver["elastic_solve_equivalents"]));
      std::string phases;
      for (const auto &phase : seconds.items())
        if (!phase.value().is_null())
          phases += (phases.empty() ? "" : ", ") + phase.key() +
                    format(" %.2f", phase.value().get<double>());
      log.line(format("  %-24s ", "seconds") + phases);
      log.line(format("  %-24s %.0f", "peak memory [MB]",
                      summary["peak_memory_MB"].get<double>()));
    }

    // A word on successive approximations that hardly contract.
    void print_contraction(Log &log, const json &summary)
    {
      const json &contraction = summary["solver"]["contraction"];
      if (!contraction.is_null() && contraction.get<double>() > worrying_contraction)
        {
          log.line();
          log.line(format("WARNING: the successive approximations change the "
                          "residual by a factor of %.3f a step; near 1 the "
                          "answer may not be the only one. 'Contact "
                          "solver/Method = newton' with 'Coulomb iteration = "
                          "direct' does without them.",
                          contraction.get<double>()));
        }
    }
  } // namespace

  std::string step_name(const ContactSolverParameters &parameters, const bool is_coulomb)
  {
    const std::string &method = parameters.method;
    const bool has_products   = method == "mpgp" || method == "squares";
    if (is_coulomb && (has_products || parameters.coulomb_iteration == "fixed point"))
      return "Coulomb step";
    return method == "gauss seidel"                       ? "sweep"
           : method == "newton" || parameters.is_primal() ? "Newton step"
           : has_products                                 ? "20 products"
                                                          : "iteration";
  }

  std::string explain(const SolveStatus &solution, const ContactConditions &conditions,
                      const double tolerance)
  {
    if (solution.converged)
      return {};
    const std::string out_of_reach = conditions.why_out_of_reach(tolerance);
    return format("%s, the tolerance is %g; ", conditions.worst().c_str(), tolerance) +
           (solution.interrupted    ? "the answer is not certified"
            : !out_of_reach.empty() ? out_of_reach
                                    : solution.reason);
  }

  std::string describe_mesh_error(const json &mesh_error, const Parameters &parameters)
  {
    if (mesh_error.is_null())
      return {};
    const double error = mesh_error["relative_energy_error"].get<double>();
    std::string text   = error < 1e-4 ? std::string("Mesh: estimated error below 0.01 %")
                         : error > 1.
                           ? std::string("Mesh: estimated error above 100 %")
                           : format("Mesh: estimated error %.2g %%", 100. * error);
    text += " of the energy norm";
    if (mesh_error["sampled"].get<bool>())
      text += format(" (from a sample of %llu cells)",
                     mesh_error["cells_sampled"].get<unsigned long long>());
    if (error < small_mesh_error)
      return text + ".";

    if (error > large_mesh_error)
      text += ": stresses and pressures are not to be trusted yet";
    // geometric multigrid works on uniform meshes alone
    return text + (parameters.stiffness_solver.type == "multigrid"
                     ? "; 'Geometry/Global refinement' lowers it."
                   : parameters.refinement.adaptive_steps > 0
                     ? "; more 'Refinement/Adaptive steps' lower it."
                     : "; 'Refinement/Adaptive steps' lowers it.");
  }

  void print_report(Log &log, const json &summary, const double tolerance,
                    const std::string &reason, const bool with_costs)
  {
    print_contact(log, summary);
    print_certificate(log, summary, tolerance);
    if (with_costs)
      print_costs(log, summary);
    print_contraction(log, summary);

    log.line();
    if (summary["converged"].get<bool>())
      log.line(format("CERTIFIED: the discrete problem is solved (every deciding "
                      "figure is within %g).",
                      tolerance));
    else
      log.line(
        (summary["interrupted"].get<bool>() ? "INTERRUPTED: " : "NOT CONVERGED: ") +
        reason + ".");
  }
} // namespace stiction
