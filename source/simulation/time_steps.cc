#include <stiction/simulation/time_steps.h>

#include <cmath>
#include <limits>
#include <utility>

namespace stiction
{
  TimeSteps::TimeSteps(const double start, std::vector<double> times,
                       const double smallest)
    : times_(std::move(times))
    , smallest_(smallest)
    , reached_(start)
    , longest_(std::numeric_limits<double>::infinity())
  {
  }

  double TimeSteps::time() const
  {
    // in equal steps to the next time asked for; rounding makes no step of its own
    const double way = times_[next_] - reached_;
    const double n   = std::ceil(way / longest_ * (1. - 1e-9));
    return n <= 1. ? times_[next_] : reached_ + way / n;
  }

  void TimeSteps::accept()
  {
    reached_ = time();
    if (reached_ == times_[next_])
      ++next_;
    ++n_taken_;
    if (++n_in_a_row_ % 2 == 0)
      longest_ *= 2.;
  }

  bool TimeSteps::cut()
  {
    const double half = (time() - reached_) / 2.;
    if (smallest_ == 0. || half < smallest_ || reached_ + half == reached_)
      return false;
    longest_    = half;
    n_in_a_row_ = 0;
    return true;
  }
} // namespace stiction
