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
    void add(const double residual) { residuals_.push_back(residual); }
    void clear() { residuals_.clear(); }

    /// Whether the last one is well below that of so many steps before, or there was none
    /// yet, and steps do not go back and forth between two states.
    bool falls(std::size_t horizon) const;

  private:
    bool comes_back() const;

    std::vector<double> residuals_;
  };
} // namespace stiction
