#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace stiction
{
  class Log;

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
      /// ... which can be announced under this name.
      Scope(double &seconds, Phases &phases, const std::string &name);
      ~Scope();
      Scope(const Scope &)            = delete;
      Scope &operator=(const Scope &) = delete;

    private:
      double &seconds_;
      Phases *phases_ = nullptr;
      const std::chrono::steady_clock::time_point begin_;
    };

    Phases() = default;
    ~Phases();

    /// From now on, where nothing is said for long, a line tells which phase is
    /// at work. The log must outlive the object. To be called once.
    void announce(Log &log);

    /// To be kept as a local variable.
    Scope scope(const std::string &phase) { return {seconds_[phase], *this, phase}; }

    /// Sets a phase that was measured otherwise.
    void set(const std::string &phase, double seconds) { seconds_[phase] = seconds; }

    /// Throws std::out_of_range if there was no such phase.
    double seconds(const std::string &phase) const { return seconds_.at(phase); }

    /// The section "seconds" of summary.json: nothing for what did not happen.
    /// "contact_solve" has within it stiffness_setup, dual_operator and the
    /// iterations, "yardsticks" the elastic solves and factorisations; "other"
    /// is what of "total" belongs to no phase.
    std::map<std::string, std::optional<double>> all_seconds() const;

  private:
    struct Running
    {
      std::string name;
      std::chrono::steady_clock::time_point begin;
    };

    std::map<std::string, double> seconds_;
    std::vector<Running> running_; ///< the innermost one last
    std::mutex mutex_;             ///< of running_ and is_over_
    std::condition_variable wake_up_;
    bool is_over_ = false;
    std::thread announcer_;
  };
} // namespace stiction
