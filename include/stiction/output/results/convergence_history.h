#pragma once

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
    /// @param has_meshes whether the problem is solved on one mesh after the
    ///   other: then a row tells which.
    /// @param has_times whether it is solved at several times: then a row tells
    ///   which.
    ConvergenceHistory(Log &log, std::string step_name, bool on_levels, bool print,
                       bool has_meshes = false, bool has_times = false);

    /// What follows belongs to another time.
    void begin_time(double time);

    /// What follows belongs to the next mesh.
    void begin_mesh();

    void add(const ContactStep &step);

    /// Writes the table with ',' between columns.
    void write(std::ostream &out) const;

  private:
    void print_header();
    void print_row(const ContactStep &step);

    Log &log_;
    const bool on_levels_;
    const bool print_, has_meshes_, has_times_;
    unsigned int mesh_ = 0;
    double time_       = 0.;
    bool has_header_   = false; ///< on the screen, of this mesh
    const std::string step_name_;
    std::string rows_; ///< of convergence.csv
  };
} // namespace stiction
