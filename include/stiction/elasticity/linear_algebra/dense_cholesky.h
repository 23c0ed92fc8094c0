#pragma once

namespace stiction
{
  /// LAPACK's Cholesky routines for a dense symmetric positive definite matrix
  /// of order n, stored by columns; only the lower triangle is read and
  /// written. (Apart from Eigen, whose declarations of the same BLAS clash
  /// with deal.II's.) All throw std::runtime_error if the matrix is not
  /// positive definite.
  namespace dense_cholesky
  {
    /// Replaces the matrix by its factor L, A = L Lᵀ.
    void factorize(double *A, int n);

    /// Replaces the factor L by A⁻¹.
    void invert(double *L, int n);

    /// Replaces b by A⁻¹ b, given the factor.
    void solve(const double *L, int n, double *b);
  } // namespace dense_cholesky
} // namespace stiction
