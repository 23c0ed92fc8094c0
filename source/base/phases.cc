#include <stiction/base/log.h>
#include <stiction/base/phases.h>

#include <algorithm>

namespace stiction
{
  namespace
  {
    using Clock = std::chrono::steady_clock;

    double seconds_since(const Clock::time_point begin)
    {
      return std::chrono::duration<double>(Clock::now() - begin).count();
    }

    // A silence longer than this one is broken; then twice as long each time.
    constexpr double first_silence = 5., longest_silence = 60.;
  } // namespace

  Phases::Scope::Scope(double &seconds)
    : seconds_(seconds)
    , begin_(Clock::now())
  {
  }

  Phases::Scope::Scope(double &seconds, Phases &phases, const std::string &name)
    : seconds_(seconds)
    , phases_(&phases)
    , begin_(Clock::now())
  {
    const std::lock_guard<std::mutex> lock(phases.mutex_);
    phases.running_.push_back({name, begin_});
  }

  Phases::Scope::~Scope()
  {
    seconds_ += seconds_since(begin_);
    if (phases_ == nullptr)
      return;
    const std::lock_guard<std::mutex> lock(phases_->mutex_);
    phases_->running_.pop_back();
  }

  Phases::~Phases()
  {
    if (!announcer_.joinable())
      return;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_over_ = true;
    }
    wake_up_.notify_one();
    announcer_.join();
  }

  void Phases::announce(Log &log)
  {
    announcer_ = std::thread([this, &log]() {
      double patience = first_silence;
      Clock::time_point announced{};
      std::unique_lock<std::mutex> lock(mutex_);
      while (
        !wake_up_.wait_for(lock, std::chrono::seconds(1), [this]() { return is_over_; }))
        {
          if (running_.empty())
            continue;
          const Running &phase = running_.back();
          if (phase.begin != announced)
            patience = first_silence;
          const double elapsed = seconds_since(phase.begin);
          if (std::min(elapsed, log.seconds_of_silence()) < patience)
            continue;
          std::string name = phase.name;
          std::replace(name.begin(), name.end(), '_', ' ');
          log.line(format("  ... %s, %.0f s", name.c_str(), elapsed));
          announced = phase.begin;
          patience  = std::min(2. * patience, longest_silence);
        }
    });
  }

  std::map<std::string, std::optional<double>> Phases::all_seconds() const
  {
    // those that no other one is around
    static const std::vector<std::string> outermost = {
      "reading",     "mesh",           "assembly",   "contact_surface", "contact_solve",
      "certificate", "error_estimate", "yardsticks", "output"};
    std::map<std::string, std::optional<double>> all(seconds_.begin(), seconds_.end());
    for (const Running &phase : running_) // what they took until now
      *all[phase.name] += seconds_since(phase.begin);
    for (const char *phase :
         {"reading", "mesh", "assembly", "contact_surface", "stiffness_setup",
          "dual_operator", "dual_iteration", "displacement_iteration", "contact_solve",
          "certificate", "error_estimate", "elastic_solve", "elastic_solve_iteration",
          "sparse_factorization", "dual_cholesky", "yardsticks", "output", "total"})
      all.try_emplace(phase);
    if (all["total"])
      {
        double other = *all["total"];
        for (const std::string &phase : outermost)
          other -= all[phase].value_or(0.);
        all["other"] = other;
      }
    return all;
  }
} // namespace stiction
