#pragma once

#include "cell_kernel_vector.h"

#ifdef __SSE2__
#  include <immintrin.h>
#endif

// Nodes come as three numbers in a row, and registers hold a component of as
// many nodes as there are lanes. Nodes are added to one after the other, since
// elements of a batch share nodes.

namespace stiction::cell_kernel
{
  namespace
  {
#ifdef __SSE2__
    // ------------------------------------------------------ 128 bits, double
    STICTION_INLINE void load_nodes(__m128d &x, __m128d &y, __m128d &z,
                                    const double *const src,
                                    const std::uint32_t *const entries)
    {
      const double *const a = src + entries[0], *const b = src + entries[1];
      const __m128d of_a = _mm_loadu_pd(a), of_b = _mm_loadu_pd(b);
      x = _mm_unpacklo_pd(of_a, of_b);
      y = _mm_unpackhi_pd(of_a, of_b);
      z = _mm_loadh_pd(_mm_load_sd(a + 2), b + 2);
    }

    STICTION_INLINE void add_to_node(double *const node, const __m128d xy,
                                     const __m128d z)
    {
      _mm_storeu_pd(node, _mm_add_pd(_mm_loadu_pd(node), xy));
      _mm_store_sd(node + 2, _mm_add_sd(z, _mm_load_sd(node + 2)));
    }

    STICTION_INLINE void add_to_nodes(double *const dst,
                                      const std::uint32_t *const entries, const __m128d x,
                                      const __m128d y, const __m128d z)
    {
      add_to_node(dst + entries[0], _mm_unpacklo_pd(x, y), z);
      add_to_node(dst + entries[1], _mm_unpackhi_pd(x, y), _mm_unpackhi_pd(z, z));
    }

    // ------------------------------------------------------- 128 bits, float
    STICTION_INLINE const __m64 *pair(const float *const xy)
    {
      return reinterpret_cast<const __m64 *>(xy);
    }

    STICTION_INLINE __m64 *pair(float *const xy) { return reinterpret_cast<__m64 *>(xy); }

    STICTION_INLINE __m128 load_pairs(const float *const a, const float *const b)
    {
      return _mm_loadh_pi(_mm_loadl_pi(_mm_setzero_ps(), pair(a)), pair(b));
    }

    STICTION_INLINE void load_nodes(__m128 &x, __m128 &y, __m128 &z,
                                    const float *const src,
                                    const std::uint32_t *const entries)
    {
      const float *const a = src + entries[0], *const b = src + entries[1];
      const float *const c = src + entries[2], *const d = src + entries[3];
      const __m128 ab = load_pairs(a, b), cd = load_pairs(c, d);
      x = _mm_shuffle_ps(ab, cd, 0x88);
      y = _mm_shuffle_ps(ab, cd, 0xdd);
      z = _mm_setr_ps(a[2], b[2], c[2], d[2]);
    }

    // Two nodes, one after the other; z is in lanes first_lane and the next.
    template<int first_lane>
    STICTION_INLINE void add_to_two_nodes(float *const a, float *const b, const __m128 xy,
                                          const __m128 z)
    {
      const __m128 old_a = _mm_loadl_pi(_mm_setzero_ps(), pair(a));
      _mm_storel_pi(pair(a), _mm_add_ps(old_a, xy));
      a[2] += z[first_lane];
      const __m128 old_b = _mm_loadh_pi(_mm_setzero_ps(), pair(b));
      _mm_storeh_pi(pair(b), _mm_add_ps(old_b, xy));
      b[2] += z[first_lane + 1];
    }

    STICTION_INLINE void add_to_nodes(float *const dst,
                                      const std::uint32_t *const entries, const __m128 x,
                                      const __m128 y, const __m128 z)
    {
      add_to_two_nodes<0>(dst + entries[0], dst + entries[1], _mm_unpacklo_ps(x, y), z);
      add_to_two_nodes<2>(dst + entries[2], dst + entries[3], _mm_unpackhi_ps(x, y), z);
    }
#endif

#ifdef __AVX2__
    // ------------------------------------------------------ 256 bits, double
    STICTION_INLINE __m256d combine(const __m128d low, const __m128d high)
    {
      return _mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1);
    }

    STICTION_INLINE void load_nodes(__m256d &x, __m256d &y, __m256d &z,
                                    const double *const src,
                                    const std::uint32_t *const entries)
    {
      const double *const a = src + entries[0], *const b = src + entries[1];
      const double *const c = src + entries[2], *const d = src + entries[3];
      const __m256d ac = combine(_mm_loadu_pd(a), _mm_loadu_pd(c));
      const __m256d bd = combine(_mm_loadu_pd(b), _mm_loadu_pd(d));
      x                = _mm256_unpacklo_pd(ac, bd);
      y                = _mm256_unpackhi_pd(ac, bd);
      z                = combine(_mm_loadh_pd(_mm_load_sd(a + 2), b + 2),
                                 _mm_loadh_pd(_mm_load_sd(c + 2), d + 2));
    }

    STICTION_INLINE void add_to_nodes(double *const dst,
                                      const std::uint32_t *const entries, const __m256d x,
                                      const __m256d y, const __m256d z)
    {
      const __m256d ac = _mm256_unpacklo_pd(x, y);
      const __m256d bd = _mm256_unpackhi_pd(x, y);
      const __m128d ab = _mm256_castpd256_pd128(z);
      const __m128d cd = _mm256_extractf128_pd(z, 1);
      add_to_node(dst + entries[0], _mm256_castpd256_pd128(ac), ab);
      add_to_node(dst + entries[1], _mm256_castpd256_pd128(bd), _mm_unpackhi_pd(ab, ab));
      add_to_node(dst + entries[2], _mm256_extractf128_pd(ac, 1), cd);
      add_to_node(dst + entries[3], _mm256_extractf128_pd(bd, 1),
                  _mm_unpackhi_pd(cd, cd));
    }

    // ------------------------------------------------------- 256 bits, float
    STICTION_INLINE __m256 combine(const __m128 low, const __m128 high)
    {
      return _mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1);
    }

    STICTION_INLINE void load_nodes(__m256 &x, __m256 &y, __m256 &z,
                                    const float *const src,
                                    const std::uint32_t *const entries)
    {
      __m128 low[3], high[3];
      load_nodes(low[0], low[1], low[2], src, entries);
      load_nodes(high[0], high[1], high[2], src, entries + 4);
      x = combine(low[0], high[0]);
      y = combine(low[1], high[1]);
      z = combine(low[2], high[2]);
    }

    STICTION_INLINE void add_to_nodes(float *const dst,
                                      const std::uint32_t *const entries, const __m256 x,
                                      const __m256 y, const __m256 z)
    {
      add_to_nodes(dst, entries, _mm256_castps256_ps128(x), _mm256_castps256_ps128(y),
                   _mm256_castps256_ps128(z));
      add_to_nodes(dst, entries + 4, _mm256_extractf128_ps(x, 1),
                   _mm256_extractf128_ps(y, 1), _mm256_extractf128_ps(z, 1));
    }
#endif

#ifndef __SSE2__
    // ------------------------------------------------------------- elsewhere
    template<typename V, typename Number>
    STICTION_INLINE void load_nodes(V &x, V &y, V &z, const Number *const src,
                                    const std::uint32_t *const entries)
    {
      for (unsigned int l = 0; l < Register<Number>::lanes; ++l)
        {
          x[l] = src[entries[l]];
          y[l] = src[entries[l] + 1];
          z[l] = src[entries[l] + 2];
        }
    }

    template<typename V, typename Number>
    STICTION_INLINE void add_to_nodes(Number *const dst,
                                      const std::uint32_t *const entries, const V x,
                                      const V y, const V z)
    {
      for (unsigned int l = 0; l < Register<Number>::lanes; ++l)
        {
          dst[entries[l]] += x[l];
          dst[entries[l] + 1] += y[l];
          dst[entries[l] + 2] += z[l];
        }
    }
#endif

    // ------------------------------------------------------ a batch of nodes
    /// The three components at the nodes of a batch, component by component.
    template<typename Number, int n_nodes> struct Values
    {
      Vector<Number> of[3][n_nodes];
    };

    template<typename Number, int n_nodes>
    STICTION_INLINE void gather(Values<Number, n_nodes> &values, const Number *const src,
                                const std::uint32_t *const entries)
    {
      for (int n = 0; n < n_nodes; ++n)
        {
          Vector<Number> x{}, y{}, z{};
          load_nodes(x, y, z, src, entries + n * Register<Number>::lanes);
          values.of[0][n] = x;
          values.of[1][n] = y;
          values.of[2][n] = z;
        }
    }

    // n_left elements are left, of which the batch has as many as it can.
    template<typename Number, int n_nodes>
    STICTION_INLINE void scatter_add(Number *const dst,
                                     const std::uint32_t *const entries,
                                     const Values<Number, n_nodes> &values,
                                     const std::size_t n_left)
    {
      constexpr unsigned int lanes = Register<Number>::lanes;
      if (n_left >= lanes)
        for (int n = 0; n < n_nodes; ++n)
          add_to_nodes(dst, entries + n * lanes, values.of[0][n], values.of[1][n],
                       values.of[2][n]);
      else
        for (int n = 0; n < n_nodes; ++n)
          for (unsigned int l = 0; l < n_left; ++l)
            for (int c = 0; c < 3; ++c)
              dst[entries[n * lanes + l] + c] += values.of[c][n][l];
    }
  } // namespace
} // namespace stiction::cell_kernel
