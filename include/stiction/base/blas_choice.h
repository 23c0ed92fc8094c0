#pragma once

#include <string>

namespace stiction
{
  /// Starts this process again, once, with the environment variable
  /// OPENBLAS_CORETYPE, if OpenBLAS takes the processor for one that knows no
  /// AVX2 though it does: version 0.3.21, which is Debian 12's, has not heard
  /// of later processors and computes five times slower on them than it could.
  ///
  /// To be called before MPI is initialised. Does nothing where that variable
  /// is set already, where BLAS is another library, or if starting fails.
  void choose_blas_kernels();

  /// What choose_blas_kernels() did to this process, a sentence; empty if it
  /// did nothing.
  std::string blas_remark();
} // namespace stiction
