#pragma once

namespace stiction
{
  /// A step of the Chebyshev polynomials of the fourth kind (Lottes 2022): the next
  /// direction is keep × the last one + take × D⁻¹ residual.
  struct ChebyshevStep
  {
    static constexpr unsigned int degree = 2; ///< steps of a smoothing

    /// @param k the number of the step, from 0; @param largest_eigenvalue of D⁻¹A.
    ChebyshevStep(const unsigned int k, const float largest_eigenvalue)
    {
      const auto j = static_cast<float>(k);
      keep         = (2.f * j - 1.f) / (2.f * j + 3.f);
      take         = (8.f * j + 4.f) / ((2.f * j + 3.f) * largest_eigenvalue);
    }

    float keep, take;
  };
} // namespace stiction
