#ifndef stiction_output_phases_h
#define stiction_output_phases_h

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <map>
#include <string>

namespace stiction
{
  /// The wall time of the phases of a run in seconds, by their names in
  /// summary.json.
  class Phases
  {
  public:
    /// Adds the wall time of its own life to a phase.
    class Scope
    {
    public:
      explicit Scope(double &seconds);
      ~Scope();
      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;

    private:
      double &seconds_;
      const std::chrono::steady_clock::time_point begin_;
    };

    /// To be kept as a local variable.
    Scope
    scope(const std::string &phase)
    {
      return Scope(seconds_[phase]);
    }

    /// Sets a phase that was measured otherwise.
    void
    set(const std::string &phase, double seconds)
    {
      seconds_[phase] = seconds;
    }

    /// Throws std::out_of_range if there was no such phase.
    double
    seconds(const std::string &phase) const
    {
      return seconds_.at(phase);
    }

    /// The section "seconds" of summary.json: null for what did not happen.
    nlohmann::json
    to_json() const;

  private:
    std::map<std::string, double> seconds_;
  };
} // namespace stiction

#endif
