#ifndef stiction_elasticity_cell_kernel_vector_h
#define stiction_elasticity_cell_kernel_vector_h

#include "cell_kernel.h"

// STICTION_VECTOR_BYTES is defined by the file that includes this.

#define STICTION_INLINE static inline __attribute__((always_inline))

namespace stiction::cell_kernel
{
  namespace
  {
    /// A register: as many numbers as fit, one of each element of a batch.
    template<typename Number>
    struct Register
    {
      static constexpr unsigned int lanes =
        STICTION_VECTOR_BYTES / sizeof(Number);
      typedef Number Type __attribute__((vector_size(STICTION_VECTOR_BYTES)));

      // Wide registers are filled with one number at no cost, narrow ones
      // read it repeated.
#if STICTION_VECTOR_BYTES == 16
      static constexpr bool repeats = true;
      typedef Type Coefficient;
#else
      static constexpr bool repeats = false;
      typedef Number Coefficient;
#endif
    };

    template<typename Number>
    using Vector = typename Register<Number>::Type;

    /// The three components at the nodes of a batch, component by component.
    template<typename Number, int n_nodes>
    struct Values
    {
      Vector<Number> of[3][n_nodes];
    };



    template<typename Number, int n_nodes>
    STICTION_INLINE void
    gather(Values<Number, n_nodes> &values,
           const std::uint32_t *const entries,
           const Number *const src)
    {
      constexpr unsigned int lanes = Register<Number>::lanes;
      for (int n = 0; n < n_nodes; ++n)
        {
          Vector<Number> x, y, z;
#pragma GCC unroll 16
          for (unsigned int l = 0; l < lanes; ++l)
            {
              const Number *const node = src + entries[n * lanes + l];

              x[l] = node[0];
              y[l] = node[1];
              z[l] = node[2];
            }
          values.of[0][n] = x;
          values.of[1][n] = y;
          values.of[2][n] = z;
        }
    }



    // Elements of a batch share nodes, so they are added one after the other.
    template<typename Number, int n_nodes>
    STICTION_INLINE void
    scatter_add(Number *const dst,
                const std::uint32_t *const entries,
                const Values<Number, n_nodes> &values,
                const std::size_t n_active)
    {
      constexpr unsigned int lanes = Register<Number>::lanes;
      if (n_active >= lanes)
        for (int n = 0; n < n_nodes; ++n)
          {
            const Vector<Number> x = values.of[0][n];
            const Vector<Number> y = values.of[1][n];
            const Vector<Number> z = values.of[2][n];
#pragma GCC unroll 16
            for (unsigned int l = 0; l < lanes; ++l)
              {
                Number *const node = dst + entries[n * lanes + l];
                node[0] += x[l];
                node[1] += y[l];
                node[2] += z[l];
              }
          }
      else
        for (int n = 0; n < n_nodes; ++n)
          for (unsigned int l = 0; l < n_active; ++l)
            for (int c = 0; c < 3; ++c)
              dst[entries[n * lanes + l] + c] += values.of[c][n][l];
    }
  } // namespace
} // namespace stiction::cell_kernel

#endif
