#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace stiction
{
  class ParameterFile;

  /// The section 'Output'.
  struct OutputParameters : dealii::ParameterAcceptor
  {
    OutputParameters();

    /// Throws InputError about what a pattern cannot see.
    void check(const ParameterFile &source) const;

    /// Whether solution.pvtu gets the fields that can be left out.
    bool has_all_fields() const { return fields == "all"; }

    std::string directory = "output/stiction";
    std::string export_directory;
    std::string units     = "none";
    bool write_solution   = true;
    std::string fields    = "all";
    bool double_precision = false;
    unsigned int every    = 1;
    bool print_progress   = true;
  };
} // namespace stiction
