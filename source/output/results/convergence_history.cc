#include <stiction/base/log.h>
#include <stiction/output/results/convergence_history.h>
#include <stiction/qp/certified_solve.h>

#include <sstream>
#include <vector>

namespace stiction
{
  ConvergenceHistory::ConvergenceHistory(Log &log, const std::string &step_name,
                                         const bool on_levels, const bool print,
                                         const bool has_meshes)
    : log_(log)
    , on_levels_(on_levels)
    , print_(print)
    , has_meshes_(has_meshes)
    , step_name_(step_name)
  {
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
    has_header_ = has_rows_ = true;
    if (print_)
      print_row(step);

    if (has_meshes_)
      table_.add_value("mesh", mesh_);
    table_.add_value("step", step.step);
    if (on_levels_)
      table_.add_value("unknowns", static_cast<unsigned int>(step.unknowns));
    table_.add_value("iterations", step.iterations);
    if (!on_levels_)
      table_.add_value("dual_multiplications", step.multiplications);
    table_.add_value("kkt_residual", step.residual);
    if (!on_levels_)
      table_.add_value("relative_change", step.change);
    table_.add_value("contraction", step.contraction);
    table_.add_value("normal_force", step.normal_force);
  }

  void ConvergenceHistory::write(std::ostream &out) const
  {
    // TableHandler separates by blanks; its rows are rewritten with commas
    dealii::TableHandler table       = table_;
    std::vector<std::string> columns = {"kkt_residual", "normal_force"};
    if (!on_levels_)
      columns.emplace_back("relative_change");
    for (const std::string &column : columns)
      if (has_rows_)
        {
          table.set_precision(column, 9);
          table.set_scientific(column, true);
        }
    std::stringstream text;
    if (has_rows_)
      table.write_text(
        text, dealii::TableHandler::simple_table_with_separate_column_description);

    out << (has_meshes_ ? "mesh," : "")
        << (on_levels_ ? "step,unknowns,iterations,kkt_residual,"
                       : "step,iterations,dual_multiplications,kkt_residual,"
                         "relative_change,")
        << "contraction,normal_force\n";
    for (std::string line; std::getline(text, line);)
      {
        if (line.empty() || line[0] == '#')
          continue;
        std::istringstream words(line);
        std::string row;
        for (std::string word; words >> word;)
          row += (row.empty() ? "" : ",") + word;
        out << row << '\n';
      }
  }
} // namespace stiction
