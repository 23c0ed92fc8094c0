#pragma once

#include "cell_kernel_affine.h"

// The product of any hexahedron by Gauss's formula with 2×2×2 points, with the
// Jacobian matrices computed on the way from the 21 modes of the cell's map.
//
// In modes u_S (of the monomials in the reference coordinates S) the
// derivative along ξ is u_ξ + η u_ξη + ζ u_ξζ + ηζ u_ξηζ. It takes four
// values, as it does not depend on ξ; with η, ζ = ±√(1/3) in the modes, they
// are sums and differences.

namespace stiction::cell_kernel
{
  namespace
  {
    template<typename Number> struct Gauss
    {
      static constexpr Number point   = Number(0.57735026918962576451L);
      static constexpr Number squared = Number(1) / Number(3);
    };

    // The two other directions of each, in order, as bits of a mode.
    constexpr int first_other[3]  = {2, 1, 1};
    constexpr int second_other[3] = {4, 4, 2};

    // The derivative in a direction at its four places, from scaled modes.
    template<int direction, typename V>
    STICTION_INLINE void differentiate(V *const values, const V *const modes)
    {
      constexpr int a = 1 << direction, b = first_other[direction],
                    c = second_other[direction];
      const V p = modes[a] + modes[a | b], q = modes[a] - modes[a | b];
      const V r = modes[a | c] + modes[7], s = modes[a | c] - modes[7];
      values[0] = q - s;
      values[1] = p - r;
      values[2] = q + s;
      values[3] = p + r;
    }

    // Its transpose: derivative_modes are those of 1, b, c and bc.
    template<typename V>
    STICTION_INLINE void integrate(V *const derivative_modes, const V *const values)
    {
      const V p = values[3] + values[1], r = values[3] - values[1];
      const V q = values[2] + values[0], s = values[2] - values[0];
      derivative_modes[0] = p + q;
      derivative_modes[1] = p - q;
      derivative_modes[2] = r + s;
      derivative_modes[3] = r - s;
    }

    // A matrix at the Gauss points, its column of a direction at four places.
    template<typename V> struct PointMatrix
    {
      V of[3][3][4];
    };

    // The index of a point among the places of a direction.
    constexpr int place(const int point, const int direction)
    {
      return direction == 0   ? point >> 1
             : direction == 1 ? (point & 1) | (point >> 1 & 2)
                              : point & 3;
    }

    // Adds what a point contributes to a place, unless it is the first to.
    template<int point, int direction, typename V>
    STICTION_INLINE void add_to_place(PointMatrix<V> &sum, const int component,
                                      const V value)
    {
      V &of_place = sum.of[component][direction][place(point, direction)];
      if constexpr (point >> direction & 1)
        of_place += value;
      else
        of_place = value;
    }

    // Stress times surface element of the reference cell at a point. du:
    // reference gradient, dx: Jacobian matrix.
    template<int point, typename V>
    STICTION_INLINE void add_stress(PointMatrix<V> &stress, const PointMatrix<V> &du,
                                    const PointMatrix<V> &dx, const V lambda, const V mu)
    {
      constexpr int i = place(point, 0), j = place(point, 1), k = place(point, 2);
      const V xx = dx.of[0][0][i], xy = dx.of[0][1][j], xz = dx.of[0][2][k];
      const V yx = dx.of[1][0][i], yy = dx.of[1][1][j], yz = dx.of[1][2][k];
      const V zx = dx.of[2][0][i], zy = dx.of[2][1][j], zz = dx.of[2][2][k];

      // the cofactors: J⁻¹ is their transpose over the determinant
      const V cxx = yy * zz - yz * zy, cxy = yz * zx - yx * zz, cxz = yx * zy - yy * zx;
      const V cyx = zy * xz - zz * xy, cyy = zz * xx - zx * xz, cyz = zx * xy - zy * xx;
      const V czx = xy * yz - xz * yy, czy = xz * yx - xx * yz, czz = xx * yy - xy * yx;
      const V inverse = V{} + 1 / (xx * cxx + xy * cxy + xz * cxz);
      const V l = lambda * inverse, m = mu * inverse, twice_m = m + m;

      // the gradient times the determinant
      const V ux = du.of[0][0][i], uy = du.of[0][1][j], uz = du.of[0][2][k];
      const V vx = du.of[1][0][i], vy = du.of[1][1][j], vz = du.of[1][2][k];
      const V wx = du.of[2][0][i], wy = du.of[2][1][j], wz = du.of[2][2][k];
      const V gxx   = ux * cxx + uy * cxy + uz * cxz;
      const V gyy   = vx * cyx + vy * cyy + vz * cyz;
      const V gzz   = wx * czx + wy * czy + wz * czz;
      const V trace = l * (gxx + gyy + gzz);
      const V sxx   = trace + twice_m * gxx;
      const V syy   = trace + twice_m * gyy;
      const V szz   = trace + twice_m * gzz;
      const V sxy = m * (ux * cyx + uy * cyy + uz * cyz + vx * cxx + vy * cxy + vz * cxz);
      const V sxz = m * (ux * czx + uy * czy + uz * czz + wx * cxx + wy * cxy + wz * cxz);
      const V syz = m * (vx * czx + vy * czy + vz * czz + wx * cyx + wy * cyy + wz * cyz);

      add_to_place<point, 0>(stress, 0, sxx * cxx + sxy * cyx + sxz * czx);
      add_to_place<point, 1>(stress, 0, sxx * cxy + sxy * cyy + sxz * czy);
      add_to_place<point, 2>(stress, 0, sxx * cxz + sxy * cyz + sxz * czz);
      add_to_place<point, 0>(stress, 1, sxy * cxx + syy * cyx + syz * czx);
      add_to_place<point, 1>(stress, 1, sxy * cxy + syy * cyy + syz * czy);
      add_to_place<point, 2>(stress, 1, sxy * cxz + syy * cyz + syz * czz);
      add_to_place<point, 0>(stress, 2, sxz * cxx + syz * cyx + szz * czx);
      add_to_place<point, 1>(stress, 2, sxz * cxy + syz * cyy + szz * czy);
      add_to_place<point, 2>(stress, 2, sxz * cxz + syz * cyz + szz * czz);
    }

    template<typename V, int... points>
    STICTION_INLINE void add_stresses(PointMatrix<V> &stress, const PointMatrix<V> &du,
                                      const PointMatrix<V> &dx, const V lambda,
                                      const V mu, std::integer_sequence<int, points...>)
    {
      (add_stress<points>(stress, du, dx, lambda, mu), ...);
    }

    // The derivatives of the displacement in all places, from nodal values.
    template<typename Number, typename V>
    STICTION_INLINE void differentiate_nodal_values(PointMatrix<V> &du, V (&u)[3][8])
    {
      for (int c = 0; c < 3; ++c)
        {
          to_modes(u[c]);
          u[c][3] *= Gauss<Number>::point;
          u[c][5] *= Gauss<Number>::point;
          u[c][6] *= Gauss<Number>::point;
          u[c][7] *= Gauss<Number>::squared;
          differentiate<0>(du.of[c][0], u[c]);
          differentiate<1>(du.of[c][1], u[c]);
          differentiate<2>(du.of[c][2], u[c]);
        }
    }

    // Its transpose.
    template<typename Number, typename V>
    STICTION_INLINE void integrate_to_nodes(V (&f)[3][8], const PointMatrix<V> &stress)
    {
      for (int c = 0; c < 3; ++c)
        {
          V x[4], y[4], z[4];
          integrate(x, stress.of[c][0]);
          integrate(y, stress.of[c][1]);
          integrate(z, stress.of[c][2]);
          f[c][0] = V{};
          f[c][1] = x[0];
          f[c][2] = y[0];
          f[c][3] = Gauss<Number>::point * (x[1] + y[1]);
          f[c][4] = z[0];
          f[c][5] = Gauss<Number>::point * (x[2] + z[1]);
          f[c][6] = Gauss<Number>::point * (y[2] + z[2]);
          f[c][7] = Gauss<Number>::squared * (x[3] + y[3] + z[3]);
          to_nodes(f[c]);
        }
    }

    template<typename Number>
    void add_general(const GeneralCells<Number> &cells, Number *const dst,
                     const Number *const src)
    {
      using V                      = Vector<Number>;
      constexpr unsigned int lanes = Register<Number>::lanes;
      const std::uint32_t *entries = cells.entries;
      const V *numbers             = reinterpret_cast<const V *>(cells.geometry);
      Values<Number, 8> u;
      PointMatrix<V> dx, du, stress;
      for (std::size_t first = 0; first < cells.n_elements; first += lanes)
        {
          gather(u, src, entries);
          differentiate_nodal_values<Number>(du, u.of);
          for (int c = 0; c < 3; ++c)
            {
              const V *const modes = numbers + 7 * c - 1;
              differentiate<0>(dx.of[c][0], modes);
              differentiate<1>(dx.of[c][1], modes);
              differentiate<2>(dx.of[c][2], modes);
            }
          add_stresses(stress, du, dx, numbers[21], numbers[22],
                       std::make_integer_sequence<int, 8>());
          integrate_to_nodes<Number>(u.of, stress);
          scatter_add(dst, entries, u, cells.n_elements - first);
          entries += 8 * lanes;
          numbers += n_general_numbers;
        }
    }
  } // namespace
} // namespace stiction::cell_kernel
