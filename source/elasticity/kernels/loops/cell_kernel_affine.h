#pragma once

#include "cell_kernel_nodes.h"

#include <utility>

// The product of an element whose map is affine: with n = 2 nodes in a
// direction a cell, with n = 3 a patch of 2×2×2 equal cells.
//
// The values on a line are transformed to the n coefficients of
//
//   n = 2:  1/2, ξ/2        n = 3:  1/4, ξ/2, w/4,
//
// with w the zigzag that is 1, −1, 1 at the nodes. In these both the mass
// matrix M and the stiffness matrix D of the line are diagonal, and
// ∫ φ_i' φ_j dξ is not zero only for the derivative of i with j = i − 1, where
// it is β for all i. Hence K couples the components of a mode with each other
// (D M M, one for each direction) and with those of at most six other modes
// (β β M, a derivative in one direction each).

namespace stiction::cell_kernel
{
  namespace
  {
    // ------------------------------------------------------- the transform
    template<typename V> STICTION_INLINE void line_to_modes(V &a, V &b)
    {
      const V sum = a + b;
      b           = b - a;
      a           = sum;
    }

    template<typename V> STICTION_INLINE void line_to_modes(V &a, V &b, V &c)
    {
      const V sum = a + c, middle = b;
      b = c - a;
      a = sum + 2 * middle;
      c = sum - 2 * middle;
    }

    // The transposed transforms.
    template<typename V> STICTION_INLINE void line_to_nodes(V &a, V &b)
    {
      const V sum = a + b;
      a           = a - b;
      b           = sum;
    }

    template<typename V> STICTION_INLINE void line_to_nodes(V &a, V &b, V &c)
    {
      const V sum = a + c, half = a - c;
      a = sum - b;
      c = sum + b;
      b = half + half;
    }

    template<typename V> STICTION_INLINE void to_modes(V (&u)[8])
    {
      V a = u[0], b = u[1], c = u[2], d = u[3];
      V e = u[4], f = u[5], g = u[6], h = u[7];
      line_to_modes(a, b), line_to_modes(c, d);
      line_to_modes(e, f), line_to_modes(g, h);
      line_to_modes(a, c), line_to_modes(b, d);
      line_to_modes(e, g), line_to_modes(f, h);
      line_to_modes(a, e), line_to_modes(b, f);
      line_to_modes(c, g), line_to_modes(d, h);
      u[0] = a, u[1] = b, u[2] = c, u[3] = d;
      u[4] = e, u[5] = f, u[6] = g, u[7] = h;
    }

    template<typename V> STICTION_INLINE void to_nodes(V (&u)[8])
    {
      V a = u[0], b = u[1], c = u[2], d = u[3];
      V e = u[4], f = u[5], g = u[6], h = u[7];
      line_to_nodes(a, e), line_to_nodes(b, f);
      line_to_nodes(c, g), line_to_nodes(d, h);
      line_to_nodes(a, c), line_to_nodes(b, d);
      line_to_nodes(e, g), line_to_nodes(f, h);
      line_to_nodes(a, b), line_to_nodes(c, d);
      line_to_nodes(e, f), line_to_nodes(g, h);
      u[0] = a, u[1] = b, u[2] = c, u[3] = d;
      u[4] = e, u[5] = f, u[6] = g, u[7] = h;
    }

    template<typename V> STICTION_INLINE void to_modes(V (&u)[27])
    {
      for (int i = 0; i < 27; i += 9)
        {
          V a = u[i], b = u[i + 1], c = u[i + 2];
          V d = u[i + 3], e = u[i + 4], f = u[i + 5];
          V g = u[i + 6], h = u[i + 7], k = u[i + 8];
          line_to_modes(a, b, c);
          line_to_modes(d, e, f);
          line_to_modes(g, h, k);
          line_to_modes(a, d, g);
          line_to_modes(b, e, h);
          line_to_modes(c, f, k);
          u[i] = a, u[i + 1] = b, u[i + 2] = c;
          u[i + 3] = d, u[i + 4] = e, u[i + 5] = f;
          u[i + 6] = g, u[i + 7] = h, u[i + 8] = k;
        }
      for (int i = 0; i < 9; ++i)
        line_to_modes(u[i], u[i + 9], u[i + 18]);
    }

    template<typename V> STICTION_INLINE void to_nodes(V (&u)[27])
    {
      for (int i = 0; i < 9; ++i)
        line_to_nodes(u[i], u[i + 9], u[i + 18]);
      for (int i = 0; i < 27; i += 9)
        {
          V a = u[i], b = u[i + 1], c = u[i + 2];
          V d = u[i + 3], e = u[i + 4], f = u[i + 5];
          V g = u[i + 6], h = u[i + 7], k = u[i + 8];
          line_to_nodes(a, d, g);
          line_to_nodes(b, e, h);
          line_to_nodes(c, f, k);
          line_to_nodes(a, b, c);
          line_to_nodes(d, e, f);
          line_to_nodes(g, h, k);
          u[i] = a, u[i + 1] = b, u[i + 2] = c;
          u[i + 3] = d, u[i + 4] = e, u[i + 5] = f;
          u[i + 6] = g, u[i + 7] = h, u[i + 8] = k;
        }
    }

    // ----------------------------------------------------------- the modes
    template<int n> struct Grid
    {
      static constexpr int size = n * n * n;

      static constexpr int stride(const int direction)
      {
        return direction == 0 ? 1 : direction == 1 ? n : n * n;
      }

      static constexpr int index(const int mode, const int direction)
      {
        return mode / stride(direction) % n;
      }

      // Whether mode couples with another one by a derivative of its own in
      // direction a and of the other's in direction b; and with which.
      static constexpr bool couples(const int mode, const int a, const int b)
      {
        return index(mode, a) >= 1 && index(mode, b) <= n - 2;
      }

      static constexpr int other(const int mode, const int a, const int b)
      {
        return mode - stride(a) + stride(b);
      }
    };

    // Boxes: direction d derives component d alone, but for shear.
    template<int n, int mode, int c, int d, typename V, typename Coefficient>
    STICTION_INLINE void add_box_coupling(V &sum, const V (&u)[3][n * n * n],
                                          const Coefficient *const coefficients)
    {
      using G               = Grid<n>;
      constexpr int third   = 3 - c - d;
      constexpr int divided = 3 * G::size + n * third + G::index(mode, third);
      constexpr int shear   = divided + 3 * n;
      if constexpr (G::couples(mode, c, d))
        sum += coefficients[divided] * u[d][G::other(mode, c, d)];
      if constexpr (G::couples(mode, d, c))
        sum += coefficients[shear] * u[d][G::other(mode, d, c)];
    }

    template<int n, int mode, int c, typename V, typename Coefficient>
    STICTION_INLINE void box_component(V (&f)[3][n * n * n], const V (&u)[3][n * n * n],
                                       const Coefficient *const coefficients)
    {
      V sum = coefficients[Grid<n>::size * c + mode] * u[c][mode];
      add_box_coupling<n, mode, c, (c + 1) % 3>(sum, u, coefficients);
      add_box_coupling<n, mode, c, (c + 2) % 3>(sum, u, coefficients);
      f[c][mode] = sum;
    }

    template<int n, typename V, typename Coefficient, int... modes>
    STICTION_INLINE void box_modes(V (&f)[3][n * n * n], const V (&u)[3][n * n * n],
                                   const Coefficient *const coefficients,
                                   std::integer_sequence<int, modes...>)
    {
      (box_component<n, modes, 0>(f, u, coefficients), ...);
      (box_component<n, modes, 1>(f, u, coefficients), ...);
      (box_component<n, modes, 2>(f, u, coefficients), ...);
    }

    // Any affine map: 3×3 matrices instead of numbers.
    template<int n, int mode, int a, int b, typename V, typename Coefficient>
    STICTION_INLINE void add_affine_coupling(V &x, V &y, V &z, const V (&u)[3][n * n * n],
                                             const Coefficient *const coefficients)
    {
      using G = Grid<n>;
      if constexpr (G::couples(mode, a, b))
        {
          constexpr int third = 3 - a - b;
          // the matrix of (a, b) is stored, that of (b, a) is its transpose
          constexpr bool is_stored = b == (a + 1) % 3;
          constexpr int i          = is_stored ? 3 : 1;
          constexpr int j          = is_stored ? 1 : 3;
          constexpr int other      = G::other(mode, a, b);
          const Coefficient *const m =
            coefficients + 6 * G::size + 9 * (n * third + G::index(mode, third));
          x += m[0] * u[0][other] + m[j] * u[1][other] + m[2 * j] * u[2][other];
          y += m[i] * u[0][other] + m[i + j] * u[1][other] + m[i + 2 * j] * u[2][other];
          z += m[2 * i] * u[0][other] + m[2 * i + j] * u[1][other] +
               m[2 * i + 2 * j] * u[2][other];
        }
    }

    template<int n, int mode, typename V, typename Coefficient>
    STICTION_INLINE void affine_mode(V (&f)[3][n * n * n], const V (&u)[3][n * n * n],
                                     const Coefficient *const coefficients)
    {
      const Coefficient *const s = coefficients + 6 * mode;
      const V p = u[0][mode], q = u[1][mode], r = u[2][mode];
      V x = s[0] * p + s[5] * q + s[4] * r;
      V y = s[5] * p + s[1] * q + s[3] * r;
      V z = s[4] * p + s[3] * q + s[2] * r;
      add_affine_coupling<n, mode, 0, 1>(x, y, z, u, coefficients);
      add_affine_coupling<n, mode, 1, 0>(x, y, z, u, coefficients);
      add_affine_coupling<n, mode, 1, 2>(x, y, z, u, coefficients);
      add_affine_coupling<n, mode, 2, 1>(x, y, z, u, coefficients);
      add_affine_coupling<n, mode, 2, 0>(x, y, z, u, coefficients);
      add_affine_coupling<n, mode, 0, 2>(x, y, z, u, coefficients);
      f[0][mode] = x;
      f[1][mode] = y;
      f[2][mode] = z;
    }

    template<int n, typename V, typename Coefficient, int... modes>
    STICTION_INLINE void affine_modes(V (&f)[3][n * n * n], const V (&u)[3][n * n * n],
                                      const Coefficient *const coefficients,
                                      std::integer_sequence<int, modes...>)
    {
      (affine_mode<n, modes>(f, u, coefficients), ...);
    }

    // --------------------------------------------------------- the product
    template<typename Number, int n, bool is_box>
    void add_affine(const AffineElements<Number> &elements, Number *const dst,
                    const Number *const src)
    {
      constexpr int n_nodes        = n * n * n;
      constexpr unsigned int lanes = Register<Number>::lanes;
      using Sequence               = std::make_integer_sequence<int, n_nodes>;
      using Coefficient            = typename Register<Number>::Coefficient;
      const auto *const coefficients =
        reinterpret_cast<const Coefficient *>(elements.coefficients);

      Values<Number, n_nodes> u, f;
      const std::uint32_t *entries = elements.entries;
      for (std::size_t first = 0; first < elements.n_elements; first += lanes)
        {
          gather(u, src, entries);
          for (int c = 0; c < 3; ++c)
            to_modes(u.of[c]);
          if constexpr (is_box)
            box_modes<n>(f.of, u.of, coefficients, Sequence());
          else
            affine_modes<n>(f.of, u.of, coefficients, Sequence());
          for (int c = 0; c < 3; ++c)
            to_nodes(f.of[c]);
          scatter_add(dst, entries, f, elements.n_elements - first);
          entries += n_nodes * lanes;
        }
    }
  } // namespace
} // namespace stiction::cell_kernel
