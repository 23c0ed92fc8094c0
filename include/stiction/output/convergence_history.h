#ifndef stiction_output_convergence_history_h
#define stiction_output_convergence_history_h

#include <deal.II/base/table_handler.h>

#include <ostream>
#include <string>

namespace stiction
{
  class Log;
  struct ContactStep;

  /// The course of the iteration: a line on the screen and a row of
  /// convergence.csv a step.
  class ConvergenceHistory
  {
  public:
    /// @param step_name what an outermost iteration is called.
    /// @param on_levels whether the method goes through the levels of the
    ///   mesh: then a row tells the unknowns in place of products with Q.
    /// @param print whether lines are printed.
    ConvergenceHistory(Log &log,
                       const std::string &step_name,
                       bool on_levels,
                       bool print);

    void
    add(const ContactStep &step);

    /// Writes the table with ',' between columns.
    void
    write(std::ostream &out) const;

  private:
    void
    print_header();
    void
    print_row(const ContactStep &step);

    Log &log_;
    const bool on_levels_;
    const bool print_;
    bool has_header_ = false;
    const std::string step_name_;
    dealii::TableHandler table_;
  };
} // namespace stiction

#endif
