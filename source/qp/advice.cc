#include <stiction/qp/advice.h>
#include <stiction/qp/contact_scales.h>
#include <stiction/qp/sets/slip_bound.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace stiction
{
  namespace
  {
    // Fewer steps show no pace, and more iterations are none.
    constexpr std::size_t min_rows       = 4;
    constexpr double max_more_iterations = 1e5;
    // More of them than this, and than so far, and something else may be
    // better.
    constexpr double worth_waiting_for     = 100.;
    constexpr double required_fall_in_half = 0.9;
    // Where the residual as the method sees it is this part of the tolerance,
    // and the certificate's is not, more iterations are no help.
    constexpr double rounding_of_method = 0.01;
  } // namespace

  std::string advice_on_friction(const qp::SlipBound &slip_bound)
  {
    const double coefficient = slip_bound.largest_coefficient();
    if (coefficient < qp::SlipBound::large_coefficient)
      return {};
    std::ostringstream out;
    out << ", or lower the coefficient of friction: with " << coefficient
        << " there may be no solution or several";
    return out.str();
  }

  std::string advice_on_rounding(const double residual)
  {
    return residual <= largest_tolerance
             ? "rounding prevents a smaller one, raise 'Contact solver/Tolerance' above "
               "that"
             : "rounding prevents a smaller one, as something moves much farther than it "
               "is strained: see whether supports, contact and friction hold all bodies";
  }

  std::string warning_on_friction(const double coefficient)
  {
    if (coefficient <= qp::SlipBound::large_coefficient)
      return {};
    std::ostringstream out;
    out << "with a coefficient of friction of " << coefficient
        << " this may not be the only solution.";
    return out.str();
  }

  void Pace::add(const unsigned int iterations, const double residual)
  {
    rows_.emplace_back(iterations, residual);
  }

  std::string Pace::advice(const double tolerance, const std::string &otherwise) const
  {
    std::string raise = "raise 'Contact solver/Maximum iterations'";
    if (rows_.size() < min_rows)
      return raise;

    // many methods do not fall in every step
    const auto middle   = rows_.begin() + static_cast<std::ptrdiff_t>(rows_.size() / 2);
    const auto smallest = [](const auto begin, const auto end) {
      return std::min_element(
               begin, end,
               [](const auto &a, const auto &b) { return a.second < b.second; })
        ->second;
    };
    const double before = smallest(rows_.begin(), middle);
    const double after  = smallest(middle, rows_.end());
    if (rows_.back().second <= rounding_of_method * tolerance)
      return "its own residual is below the tolerance already, " + otherwise;
    const double steps = rows_.back().first - (middle - 1)->first;
    const double more  = steps * std::log(after / tolerance) / std::log(before / after);
    if (!(after <= required_fall_in_half * before) || !(more <= max_more_iterations))
      return "the residual hardly falls any more, " + otherwise;

    const double unit = std::pow(10., std::floor(std::log10(std::max(more, 1.))));
    std::ostringstream out;
    out << raise << " by about " << std::ceil(std::max(more, 1.) / unit) * unit;
    if (more > std::max<double>(rows_.back().first, worth_waiting_for))
      out << ", or " << otherwise;
    return out.str();
  }
} // namespace stiction
