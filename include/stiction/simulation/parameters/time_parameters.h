#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace stiction
{
  class ParameterFile;

  /// The section 'Time': at which t the problem is solved, one step after the
  /// other.
  struct TimeParameters : dealii::ParameterAcceptor
  {
    TimeParameters();

    /// The times asked for, in ascending order. Valid after check().
    std::vector<double> times() const;

    /// Whether there is more than one step, or may be, if one is cut or the run goes on
    /// from a checkpoint.
    bool has_steps() const
    {
      return times().size() > 1 || smallest_step > 0. || checkpoint_every > 0;
    }

    /// Throws InputError where the entries cannot be read or contradict each
    /// other.
    void check(const ParameterFile &source) const;

    /// Sets the entry 'End' to the last time of a list, without which the file that was
    /// used could not be read back.
    void complete();

    double start = 0., end = 1.;
    std::string steps             = "1";
    double smallest_step          = 0.;
    unsigned int checkpoint_every = 0; ///< steps; 0: never
  };
} // namespace stiction
