#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <vector>

namespace stiction
{
  /// The times at which the problem is solved: those asked for, and others between
  /// them where a step had to be cut.
  class TimeSteps
  {
  public:
    /// @param start the time before the first step.
    /// @param times those asked for, ascending, at least one.
    /// @param smallest no step is cut into shorter ones; 0: none is cut.
    TimeSteps(double start, std::vector<double> times, double smallest);

    /// Whether the last time asked for is reached.
    bool is_finished() const { return next_ == times_.size(); }

    /// The time reached, and that of the step to take.
    double reached() const { return reached_; }
    double time() const;

    /// Of the time from where this run began to the last one asked for, what is
    /// reached.
    double part_done() const { return (reached_ - begin_) / (times_.back() - begin_); }

    /// Steps taken.
    unsigned int n_taken() const { return n_taken_; }

    /// The step was taken. After two in a row the next one may be twice as long.
    void accept();

    /// The step cannot be taken: the next try is half as long.
    /// @return false if that would be too short.
    bool cut();

    /// All that decides the steps to come, beside the times asked for.
    nlohmann::json progress() const;

    /// Goes on where others were, with the times asked for here that come after.
    void go_on_from(const nlohmann::json &progress);

  private:
    const std::vector<double> times_;
    const double smallest_;
    double begin_, reached_;
    double longest_;           ///< that a step may be now
    std::size_t next_     = 0; ///< of times_
    unsigned int n_taken_ = 0, n_in_a_row_ = 0;
  };
} // namespace stiction
