#include <stiction/base/log.h>
#include <stiction/contact/dual/contact_solver_parameters.h>
#include <stiction/output/results/report.h>
#include <stiction/output/results/run_result.h>
#include <stiction/qp/certified_solve.h>
#include <stiction/qp/contact_conditions.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace stiction
{
  namespace
  {
    using Vector3 = dealii::Tensor<1, 3>;

    // Figures are relative: below the precision of numbers they are nothing.
    constexpr double rounding_of_figures = 1e-16;

    // Parts of the energy norm: an error below the one is no matter of advice,
    // above the other nothing local is right.
    constexpr double small_mesh_error = 0.01, large_mesh_error = 0.3;

    // A geometric mean above this deserves a word.
    constexpr double worrying_contraction = 0.9;

    // The size of what is printed beside each other, where the rest is rounding.
    class Scale
    {
    public:
      void add(const Vector3 &v)
      {
        for (unsigned int c = 0; c < 3; ++c)
          largest_ = std::max(largest_, std::abs(v[c]));
      }

      std::string text_of(const Vector3 &v) const
      {
        std::string text;
        for (unsigned int c = 0; c < 3; ++c)
          text += format("%s%.6g", c == 0 ? "" : ", ",
                         std::abs(v[c]) > 1e-9 * largest_ ? v[c] : 0.);
        return text;
      }

    private:
      double largest_ = 0.;
    };

    // What holds the body, with which force and moment about the origin.
    void print_supports(Log &log, const RunResult &result)
    {
      if (result.supports.empty() && result.points.empty())
        return; // contact alone holds it
      Scale force, moment;
      force.add(result.contact.force_on_body);
      moment.add(result.contact.moment);
      for (const auto &support : result.supports)
        {
          force.add(support.force);
          moment.add(support.moment);
        }
      for (const auto &point : result.points)
        force.add(point.force);

      log.line();
      log.line(label("Supports: force", result.units.force) +
               label(" on the body, moment about the origin", result.units.moment));
      for (const auto &support : result.supports)
        {
          print_row(log, support.name, "force  " + force.text_of(support.force));
          print_row(log, "", "moment " + moment.text_of(support.moment));
        }
      for (const auto &point : result.points)
        print_row(log, "point " + format_vector("%.6g", point.at),
                  "force  " + force.text_of(point.force));
    }

    // "open 25, closed 155 (undecided 0)"
    std::string normal_counts(const RunResult::NodeCounts &counts)
    {
      return format("open %u, closed %u (undecided %u)", counts.open, counts.closed,
                    counts.undecided_normal);
    }

    // "slip 120, stick 35 (undecided 0), tied 20", nothing where no friction can act
    std::string tangential_counts(const RunResult::NodeCounts &counts)
    {
      std::string text;
      if (counts.slip + counts.stick + counts.undecided_tangential > 0)
        text = format("slip %u, stick %u (undecided %u)", counts.slip, counts.stick,
                      counts.undecided_tangential);
      if (counts.tied > 0)
        text += (text.empty() ? "" : ", ") + format("tied %u", counts.tied);
      return text;
    }

    // Of all nodes, traction and tension of tied ones.
    void print_tractions(Log &log, const std::string &indentation,
                         const RunResult::Contact &contact, const Units &units)
    {
      const auto row = [&](const std::string &name, const double value) {
        print_row(log, indentation + label(name, units.stress), format("%.6g", value));
      };
      row("largest pressure", contact.max_pressure);
      if (contact.max_pressure > 0.)
        row("  over faces", contact.max_mean_pressure);
      if (contact.tied > 0)
        {
          row("largest tension", contact.max_tension);
          row("largest tied traction", contact.max_tied_traction);
        }
    }

    // The parts of several contact boundaries.
    void print_contact_boundaries(Log &log, const RunResult &result)
    {
      const Units &units = result.units;
      Scale force, moment;
      for (const auto &boundary : result.boundaries)
        {
          force.add(boundary.force_on_body);
          moment.add(boundary.moment);
        }
      for (const auto &boundary : result.boundaries)
        {
          const std::string friction = tangential_counts(boundary);
          const bool is_pair         = !boundary.opposite.empty();
          log.line("  " + boundary.title + ": " + normal_counts(boundary) +
                   (friction.empty() ? "" : "; " + friction));
          print_row(log,
                    "  " + label(is_pair ? "force on its body" : "force on the body",
                                 units.force),
                    force.text_of(boundary.force_on_body));
          for (const auto &[name, of_one] : boundary.of_opposite)
            print_row(log, "    of " + name, force.text_of(of_one));
          print_row(log, "  " + label("tangential", units.force),
                    force.text_of(boundary.tangential_force));
          print_row(log, "  " + label("moment", units.moment),
                    moment.text_of(boundary.moment));
          print_tractions(log, "  ", boundary, units);
        }
    }

    void print_contact(Log &log, const RunResult &result)
    {
      const auto &contact = result.contact;
      log.line();
      log.line("Contact");
      print_row(log, "nodes",
                normal_counts(contact) +
                  (contact.closed + contact.tied + contact.undecided_normal > 0
                     ? ""
                     : ": nothing touches"));
      if (const std::string friction = tangential_counts(contact); !friction.empty())
        print_row(log, "nodes with friction", friction);
      if (!result.has_body)
        return;

      const Units &units = result.units;
      // of pairs it is the sum over both sides
      const bool has_obstacle = std::any_of(
        result.boundaries.begin(), result.boundaries.end(),
        [](const RunResult::ContactPart &boundary) { return boundary.opposite.empty(); });
      if (has_obstacle)
        print_row(log, label("force on the body", units.force),
                  format_vector("%.6g", contact.force_on_body));
      const bool is_one = result.boundaries.size() == 1;
      for (const auto &boundary : result.boundaries)
        {
          const auto row = [&](const std::string &name, const std::string &unit,
                               const std::string &value) {
            print_row(log,
                      is_one ? label("obstacle " + name + " by", unit)
                             : label(name, unit) + ", " + boundary.name,
                      value);
          };
          if (boundary.obstacle_displacement != Vector3())
            row("moved", units.length,
                format_vector("%.6g", boundary.obstacle_displacement));
          if (boundary.obstacle_rotation != Vector3())
            {
              row("turned", "rad", format_vector("%.6g", boundary.obstacle_rotation));
              print_row(log, label("torque about its axis", units.moment),
                        format("%.6g", boundary.torque));
            }
        }
      print_tractions(log, "", contact, units);
      print_row(log, label("largest displacement", units.length),
                format("%.6g", result.displacement.max));
      const auto energies =
        without_rounding({{result.energy.strain, result.energy.load_work,
                           result.energy.friction_dissipation}});
      print_row(log, label("energy", units.energy),
                format("strain %.6g, load %.6g, friction %.6g", energies[0], energies[1],
                       energies[2]));
      if (result.boundaries.size() > 1 || !result.boundaries.front().opposite.empty())
        print_contact_boundaries(log, result);
      print_supports(log, result);
    }

    void print_certificate(Log &log, const RunResult &result, const double tolerance)
    {
      static const std::map<std::string, const char *> meanings = {
        {"equilibrium_residual", "forces in balance at every node"},
        {"kkt_residual", "contact and friction conditions"},
        {"penetration", "depth below the foundation"},
        {"complementarity", "pressure across an open gap"},
        {"cone_violation", "friction above its bound"},
        {"force_balance", "forces in balance as a whole"},
        {"moment_balance", "moments in balance as a whole"},
        {"obstacle_force", "obstacles press with their forces"},
        {"slip_angle", "degrees between friction and slip"},
        {"duality_gap", "bound on the relative energy error"}};
      log.line();
      log.line(format("Certificate (tolerance %g)", tolerance));
      for (const auto &[name, value, decides] : result.certificate)
        log.line(format("  %-24s %9.2e  %-36s %s", name.c_str(),
                        value < rounding_of_figures ? 0. : value, meanings.at(name),
                        !decides             ? ""
                        : value <= tolerance ? "ok"
                                             : "NOT REACHED"));
      if ((result.solver.law == "coulomb" || result.solver.law == "mixed") &&
          result.certificate.back().name == "duality_gap")
        log.line("  (the duality gap is that of the last slip bound, held fixed)");
    }

    // the iterations that the method made, by name
    std::string iterations(const RunResult::Solver &solver)
    {
      std::string all;
      const auto add = [&](const unsigned int n, const char *in_words) {
        if (n > 0)
          all += format("%s%s %u", all.empty() ? "" : ", ", in_words, n);
      };
      for (const qp::IterationCount &count : qp::iteration_counts)
        add(solver.*count.number, count.in_words);
      return all.empty() ? "none" : all;
    }

    void print_costs(Log &log, const RunResult &result)
    {
      const RunResult::Solver &solver = result.solver;
      log.line();
      log.line("Cost");
      print_row(log, "iterations", iterations(solver));
      if (!solver.levels.empty())
        print_row(log, "on coarser meshes",
                  format("%u Krylov iterations", solver.coarse_krylov_iterations));
      if (solver.levels.empty() || !solver.handed_over_to.empty())
        print_row(log, "products with Q", format("%lu", solver.dual_multiplications));
      if (result.has_body && solver.levels.empty())
        print_row(log, "solves with K",
                  format("%u (%u Krylov iterations)", solver.stiffness_solves,
                         solver.stiffness_krylov_iterations));
      if (result.has_body)
        print_row(log, "elastic solves' worth",
                  solver.elastic_solve_iterations == 0
                    ? "not measured"
                    : format("%.4g", solver.elastic_solve_equivalents));
      std::string phases;
      for (const auto &[phase, seconds] : result.seconds)
        if (seconds)
          phases += (phases.empty() ? "" : ", ") + phase + format(" %.2f", *seconds);
      print_row(log, "seconds", phases);
      print_row(log, "peak memory [MB]", format("%.0f", result.peak_memory_MB));
    }

    // A word on successive approximations that hardly contract.
    void print_contraction(Log &log, const double contraction)
    {
      if (!(contraction > worrying_contraction))
        return;
      log.line();
      log.line(format("WARNING: the successive approximations change the residual by a "
                      "factor of %.3f a step; near 1 the answer may not be the only one. "
                      "'Contact solver/Method = newton' with 'Coulomb iteration = "
                      "direct' does without them.",
                      contraction));
    }

    // A sentence on the estimated error of the mesh and what lowers it.
    std::string describe(const RunResult::RelativeMeshError &mesh,
                         const std::string &remedy)
    {
      const double error = mesh.relative_energy_error;
      std::string text = error < 1e-4 ? std::string("Mesh: estimated error below 0.01 %")
                         : error > 1.
                           ? std::string("Mesh: estimated error above 100 %")
                           : format("Mesh: estimated error %.2g %%", 100. * error);
      text += " of the energy norm";
      if (mesh.sampled)
        text += format(" (from a sample of %llu cells)", mesh.cells_sampled);
      if (error < small_mesh_error)
        return text + ".";

      if (error > large_mesh_error)
        text += ": stresses and pressures are not to be trusted yet";
      return text + "; " + remedy + ".";
    }
  } // namespace

  void print_row(Log &log, const std::string &name, const std::string &text)
  {
    log.line(format("  %-24s ", name.c_str()) + text);
  }

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
    const std::string figure =
      conditions.converged(tolerance)
        ? ""
        : format("%s, the tolerance is %g; ", conditions.worst().c_str(), tolerance);
    return figure + (solution.interrupted    ? "the answer is not certified"
                     : !out_of_reach.empty() ? out_of_reach
                                             : solution.reason);
  }

  void print_report(Log &log, const RunResult &result, const double tolerance,
                    const bool prints_costs, const std::string &mesh_remedy)
  {
    print_contact(log, result);
    print_certificate(log, result, tolerance);
    if (prints_costs)
      print_costs(log, result);
    print_contraction(log, result.solver.contraction);

    log.line();
    if (result.converged)
      log.line(format("CERTIFIED: the discrete problem is solved (every deciding "
                      "figure is within %g).",
                      tolerance));
    else
      log.line((result.interrupted ? "INTERRUPTED: " : "NOT CONVERGED: ") +
               result.reason + ".");
    if (result.mesh_error.cells_sampled > 0)
      log.line(describe(result.mesh_error, mesh_remedy));
    for (const std::string &warning : result.warnings)
      log.line("WARNING: " + warning);
  }
} // namespace stiction
