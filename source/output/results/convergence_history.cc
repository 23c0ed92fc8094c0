#include <stiction/base/log.h>
#include <stiction/output/results/convergence_history.h>
#include <stiction/qp/certified_solve.h>

#include <utility>

namespace stiction
{
  ConvergenceHistory::ConvergenceHistory(Log &log, std::string step_name,
                                         const bool on_levels, const bool print,
                                         const bool has_meshes, const bool has_times)
    : log_(log)
    , on_levels_(on_levels)
    , print_(print)
    , has_meshes_(has_meshes)
    , has_times_(has_times)
    , step_name_(std::move(step_name))
  {
  }

  void ConvergenceHistory::begin_time(const double time)
  {
    time_       = time;
    has_header_ = false;
  }

  void ConvergenceHistory::begin_mesh()
  {
    ++mesh_;
    has_header_ = false;
  }

  void ConvergenceHistory::print_header()
  {
    if (on_levels_)
      log_.line(format("  %-12s %10s %10s %13s %12s", step_name_.c_str(), "unknowns",
                       "iterations", "residual", "contraction"));
    else
      log_.line(format("  %-12s %10s %9s %13s %13s %12s", step_name_.c_str(),
                       "iterations", "products", "kkt residual", "change",
                       "contraction"));
  }

  void ConvergenceHistory::print_row(const ContactStep &step)
  {
    if (on_levels_)
      log_.line(format("  %-12u %10lu %10u %13.3e %12.3f", step.step, step.unknowns,
                       step.iterations, step.residual, step.contraction));
    else
      log_.line(format("  %-12u %10u %9.1f %13.3e %13.3e %12.3f", step.step,
                       step.iterations, step.multiplications, step.residual, step.change,
                       step.contraction));
  }

  void ConvergenceHistory::add(const ContactStep &step)
  {
    if (print_ && !has_header_)
      print_header();
    has_header_ = true;
    if (print_)
      print_row(step);

    rows_ += (has_times_ ? format("%.10g,", time_) : "") +
             (has_meshes_ ? format("%u,", mesh_) : "") +
             (on_levels_ ? format("%u,%lu,%u,%.9e", step.step, step.unknowns,
                                  step.iterations, step.residual)
                         : format("%u,%u,%.4f,%.9e,%.9e", step.step, step.iterations,
                                  step.multiplications, step.residual, step.change)) +
             format(",%.4f,%.9e\n", step.contraction, step.normal_force);
  }

  void ConvergenceHistory::write(std::ostream &out) const
  {
    out << (has_times_ ? "t," : "") << (has_meshes_ ? "mesh," : "")
        << (on_levels_
              ? "step,unknowns,iterations,kkt_residual,"
              : "step,iterations,dual_multiplications,kkt_residual,relative_change,")
        << "contraction,normal_force\n"
        << rows_;
  }
} // namespace stiction
