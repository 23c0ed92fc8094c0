#include <stiction/base/log.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/simulation/parameters/time_parameters.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace stiction
{
  namespace
  {
    using dealii::Utilities::split_string_list;

    constexpr unsigned int max_steps = 100000;

    // The numbers between commas; nothing if one is none.
    std::optional<std::vector<double>> numbers_of(const std::string &text)
    {
      std::vector<double> numbers;
      for (const std::string &part : split_string_list(text, ','))
        {
          char *end           = nullptr;
          const double number = std::strtod(part.c_str(), &end);
          if (part.empty() || *end != '\0' || !(std::abs(number) <= 1e30))
            return {};
          numbers.push_back(number);
        }
      return numbers;
    }
  } // namespace

  TimeParameters::TimeParameters()
    : ParameterAcceptor("Time")
  {
    namespace Patterns = dealii::Patterns;
    add_parameter("Start", start,
                  "The time t at which the body is as it is made, without deformation "
                  "and contact forces. With one step it does not matter.",
                  prm, Patterns::Double());
    add_parameter("End", end,
                  "The last value of t in all formulas: how far the loads have grown, or "
                  "a time. There is no inertia.",
                  prm, Patterns::Double());
    add_parameter("Steps", steps,
                  "Into how many equal steps the way from Start to End is cut, or a list "
                  "of times after Start, separated by ',', of which the last one stands "
                  "in place of End. Friction acts on the slip of each step: the answer "
                  "depends on the way. 1: the problem is solved once, at End.");
    add_parameter("Smallest step", smallest_step,
                  "A step whose answer is not certified is taken back and cut in half "
                  "(several times, if need be) unless it gets shorter than this; after "
                  "two steps that are certified steps grow again. The times of 'Steps' "
                  "are always met. 0: steps are not cut.",
                  prm, Patterns::Double(0.));
    add_parameter("Checkpoint every", checkpoint_every,
                  "After so many steps, and after the last one, all from which the "
                  "program can go on is written to 'checkpoint' in the output directory; "
                  "the one before is kept as 'checkpoint.old'. 'stiction FILE.prm "
                  "--restart DIRECTORY' goes on, on any number of ranks, also with other "
                  "loads and times. Both together take 32 bytes an unknown on disk. 0: "
                  "none is written.",
                  prm, Patterns::Integer(0));
  }

  std::vector<double> TimeParameters::times() const
  {
    std::vector<double> numbers = *numbers_of(steps);
    if (numbers.size() > 1)
      return numbers;
    std::vector<double> times;
    const auto n = static_cast<unsigned int>(numbers.front());
    for (unsigned int k = 1; k < n; ++k)
      times.push_back(start + (end - start) * k / n);
    times.push_back(end);
    return times;
  }

  void TimeParameters::complete()
  {
    const auto list = dealii::Utilities::split_string_list(steps, ',');
    if (list.size() < 2)
      return;
    enter_my_subsection(prm);
    prm.set("End", list.back());
    leave_my_subsection(prm);
  }

  void TimeParameters::check(const ParameterFile &source) const
  {
    const auto require = [&](const bool condition, const std::string &entry,
                             const std::string &allowed) {
      source.require(condition, "Time/" + entry, allowed);
    };
    require(std::abs(start) <= 1e30, "Start", "must be a number of at most 1e30");
    require(std::abs(end) <= 1e30, "End", "must be a number of at most 1e30");
    require(smallest_step <= 1e30, "Smallest step", "must be a number of at most 1e30");

    const auto numbers     = numbers_of(steps);
    const std::string what = "must be a whole number from 1 to " +
                             std::to_string(max_steps) +
                             " or a list of times separated by ','";
    require(numbers && !numbers->empty() && numbers->size() <= max_steps, "Steps", what);
    if (numbers->size() == 1)
      {
        const double n = numbers->front();
        require(n >= 1. && n <= max_steps && n == std::floor(n), "Steps", what);
        require(n == 1. || end > start, "End",
                "must be after 'Start' with several steps");
        require(n == 1. || start + (end - start) / n > start, "Steps",
                "are too many for the time between 'Start' and 'End'");
      }
    else
      {
        double last = start;
        for (const double time : *numbers)
          {
            require(time > last, "Steps",
                    "each time must be after the one before and 'Start'");
            last = time;
          }
        require(source.given().count("Time/End") == 0 || end == last, "End",
                "must be the last of the times in 'Steps', or not be there");
      }
    double longest = 0., last = start;
    for (const double time : times())
      longest = std::max(longest, time - std::exchange(last, time));
    require(smallest_step <= longest / 2., "Smallest step",
            format("must be at most half of the longest step, %g, or no step is ever cut",
                   longest));
  }
} // namespace stiction
