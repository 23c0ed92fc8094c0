#pragma once

#include <stiction/elasticity/kernels/cell_stiffness.h>

#include <array>
#include <vector>

namespace stiction::cell_kernel
{
  /// The trilinear map of a cell: modes[c][S] is the coefficient of component
  /// c with the monomial in the reference coordinates in S (bits 1, 2, 4 for
  /// ξ, η, ζ in [−1, 1]). Unit: m.
  struct CellMap
  {
    CellMap() = default;

    explicit CellMap(const std::array<std::array<double, 3>, 8> &vertices);

    /// Whether the determinant is positive at all 2×2×2 Gauss points.
    bool is_valid() const;

    /// Whether it is affine but for what rounding makes of its vertices.
    bool is_affine() const;

    /// Whether it is a box along the axes, if it is affine.
    bool is_box() const;

    /// Whether the other one is this one but for a translation, if both are
    /// affine.
    bool is_congruent(const CellMap &other) const;

    /// ∂x_c/∂ξ_d at a point: [c][d].
    std::array<std::array<double, 3>, 3> jacobian(
      const std::array<double, 3> &point) const;

    double modes[3][8];

    /// What differences of coordinates are uncertain by.
    double tolerance;
  };

  /// The coefficients of the affine kernels (cell_kernel_affine.h) for a cell
  /// of this map, n = 2, or a patch of 2×2×2 of them, n = 3.
  ///
  /// Boxes: the diagonal, 3·n³ numbers; then two numbers with which components
  /// (b, c) of two modes couple, for a = 0, 1, 2 and the n mode indices in
  /// direction a: all those of ∂_b u_b ∂_c u_c, then those of ∂_c u_b ∂_b u_c.
  /// Others: the n³ symmetric 3×3 matrices of the modes (xx, yy, zz, yz, zx,
  /// xy); then those that couple modes with derivatives in directions (b, c),
  /// for a and its mode index as above, with (a, b, c) cyclic.
  std::vector<double> affine_coefficients(const CellMap &map, double lame_lambda,
                                          double shear_modulus, unsigned int n,
                                          bool is_box);

  /// The 3×3 blocks of the eight nodes on the diagonal of a cell's matrix, row
  /// by row.
  std::array<std::array<double, 9>, 8> diagonal_blocks(const CellMap &map,
                                                       double lame_lambda,
                                                       double shear_modulus);
} // namespace stiction::cell_kernel
