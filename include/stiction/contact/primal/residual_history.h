#pragma once

#include <cstddef>
#include <vector>

namespace stiction
{
  /// What residuals since Newton's method began with the present ρ tell of whether to go
  /// on with it.
  class ResidualHistory
  {
  public:
    /// What counts as a fall: to this part at most.
    static constexpr double required_fall = 0.7;

    void add(const double residual) { residuals_.push_back(residual); }
    void clear() { residuals_.clear(); }

    /// Whether the last one has fallen since so many steps before, or there are not as
    /// many yet, and steps do not go back and forth between two states.
    bool falls(std::size_t horizon) const;

  private:
    bool comes_back() const;

    std::vector<double> residuals_;
  };
} // namespace stiction
