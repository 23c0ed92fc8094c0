#include <stiction/simulation/time_steps.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stiction
{
  TimeSteps::TimeSteps(const double start, std::vector<double> times,
                       const double smallest)
    : times_(std::move(times))
    , smallest_(smallest)
    , begin_(start)
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

  nlohmann::json TimeSteps::progress() const
  {
    return {{"reached", reached_},
            {"longest", longest_}, // null: infinite
            {"taken", n_taken_},
            {"in_a_row", n_in_a_row_}};
  }

  void TimeSteps::go_on_from(const nlohmann::json &progress)
  {
    begin_ = reached_ = progress.at("reached").get<double>();
    n_taken_          = progress.at("taken").get<unsigned int>();
    n_in_a_row_       = progress.at("in_a_row").get<unsigned int>();
    if (progress.at("longest").is_number())
      longest_ = progress.at("longest").get<double>();
    // rounding makes no step of its own
    const double little = 1e-9 * (times_.back() - reached_);
    next_ =
      std::upper_bound(times_.begin(), times_.end(), reached_ + std::max(little, 0.)) -
      times_.begin();
  }
} // namespace stiction
