#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  namespace qp
  {
    class SlipBound;
  }

  /// What there is to say of the friction of a problem that no method comes
  /// closer to solving: ", or lower ..." where the coefficient is so large that
  /// there may be no solution or several, otherwise nothing.
  std::string advice_on_friction(const qp::SlipBound &slip_bound);

  /// Why a method ends where rounding leaves this residual, and what may help.
  std::string advice_on_rounding(double residual);

  /// What a certificate does not say of a solution: that there may be others,
  /// where the coefficient of friction is that large; otherwise nothing.
  ///
  /// @param coefficient the largest, in any direction.
  std::string warning_on_friction(double coefficient);

  /// How the residual falls, for those who meet the cap on iterations.
  class Pace
  {
  public:
    /// @param iterations so far, of those that the cap counts.
    void add(unsigned int iterations, double residual);

    /// "raise 'Contact solver/Maximum iterations' by about 40" if the residual
    /// was still falling, without a number if there were too few steps to tell;
    /// otherwise what else to do.
    std::string advice(double tolerance, const std::string &otherwise) const;

  private:
    std::vector<std::pair<unsigned int, double>> rows_;
  };
} // namespace stiction
