#include <stiction/contact/primal/residual_history.h>

#include <cmath>

namespace stiction
{
  namespace
  {
    // Residuals that differ by less are of the same states.
    constexpr double same = 1e-3;
  } // namespace

  bool ResidualHistory::falls(const std::size_t horizon) const
  {
    const std::size_t n = residuals_.size();
    return !comes_back() &&
           (n <= horizon ||
            residuals_[n - 1] <= required_fall * residuals_[n - 1 - horizon]);
  }

  bool ResidualHistory::comes_back() const
  {
    const auto differ = [&](const std::size_t k, const std::size_t l) {
      return std::abs(residuals_[k] - residuals_[l]) > same * residuals_[k];
    };
    const std::size_t n = residuals_.size();
    return n >= 4 && !differ(n - 1, n - 3) && !differ(n - 2, n - 4) &&
           differ(n - 1, n - 2);
  }
} // namespace stiction
