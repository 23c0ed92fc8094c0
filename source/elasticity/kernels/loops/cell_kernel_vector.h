#pragma once

#include "cell_kernel.h"

// STICTION_VECTOR_BYTES is defined by the file that includes this.

#define STICTION_INLINE inline __attribute__((always_inline))

namespace stiction::cell_kernel
{
  namespace
  {
    /// A register: as many numbers as fit, one of each element of a batch.
    template<typename Number> struct Register
    {
      static constexpr unsigned int lanes = STICTION_VECTOR_BYTES / sizeof(Number);
      using Type __attribute__((vector_size(STICTION_VECTOR_BYTES))) = Number;

      // Wide registers are filled with one number at no cost, narrow ones
      // read it repeated.
#if STICTION_VECTOR_BYTES == 16
      static constexpr bool repeats = true;
      using Coefficient             = Type;
#else
      static constexpr bool repeats = false;
      using Coefficient             = Number;
#endif
    };

    template<typename Number> using Vector = typename Register<Number>::Type;
  } // namespace
} // namespace stiction::cell_kernel
