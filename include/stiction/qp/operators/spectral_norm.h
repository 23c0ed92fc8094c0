#pragma once

namespace stiction::qp
{
  class SymmetricOperator;

  /// An upper estimate of the largest eigenvalue of a symmetric positive
  /// definite operator, sharp to a few per cent.
  ///
  /// Lanczos' method from a fixed start vector (the result is the same on
  /// every rank and in every run), stopped when the residual of the largest
  /// Ritz value θ is below @p accuracy·θ; returned is θ plus that residual.
  /// Costs at most @p max_multiplications products, typically about ten.
  /// Returns 0 for an operator of size 0 and for the zero operator.
  double spectral_norm(const SymmetricOperator &A, double accuracy = 0.05,
                       unsigned int max_multiplications = 30);
} // namespace stiction::qp
