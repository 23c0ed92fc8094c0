#include "cell_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction::cell_kernel
{
  namespace
  {
    using Matrix = std::array<std::array<double, 3>, 3>;

    std::array<double, 3> gauss_point(const unsigned int q)
    {
      static const double g = 1. / std::sqrt(3.);
      const auto side = [&](const unsigned int bit) { return (q & bit) != 0 ? g : -g; };
      return {side(1), side(2), side(4)};
    }

    // With the transposed inverse times the determinant, the cofactors.
    double determinant(const Matrix &J, Matrix &cofactors)
    {
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int c1 = (c + 1) % 3, c2 = (c + 2) % 3;
            const unsigned int d1 = (d + 1) % 3, d2 = (d + 2) % 3;

            cofactors[c][d] = J[c1][d1] * J[c2][d2] - J[c1][d2] * J[c2][d1];
          }
      double sum = 0.;
      for (unsigned int d = 0; d < 3; ++d)
        sum += J[0][d] * cofactors[0][d];
      return sum;
    }

    // Of the eight shape functions in reference coordinates, at Gauss points.
    std::array<std::array<std::array<double, 3>, 8>, 8> shape_derivatives()
    {
      std::array<std::array<std::array<double, 3>, 8>, 8> result;
      for (unsigned int q = 0; q < 8; ++q)
        for (unsigned int v = 0; v < 8; ++v)
          {
            double factor[3];
            for (unsigned int d = 0; d < 3; ++d)
              factor[d] = .5 * (1. + ((v >> d & 1) != 0 ? 1. : -1.) * gauss_point(q)[d]);
            for (unsigned int d = 0; d < 3; ++d)
              result[q][v][d] = ((v >> d & 1) != 0 ? .5 : -.5) * factor[(d + 1) % 3] *
                                factor[(d + 2) % 3];
          }
      return result;
    }

    // The energy of two displacements with gradients a ⊗ e_row and b ⊗ e_column
    // in isotropic elasticity, a unit of volume: [row][column].
    Matrix elasticity(const std::array<double, 3> &a, const std::array<double, 3> &b,
                      const double lame_lambda, const double shear_modulus)
    {
      const double product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      Matrix result;
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          result[c][d] = lame_lambda * a[c] * b[d] +
                         shear_modulus * (a[d] * b[c] + (c == d ? product : 0.));
      return result;
    }
  } // namespace

  CellMap::CellMap(const std::array<std::array<double, 3>, 8> &vertices)
  {
    double largest = 0., size = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        double *const values = modes[c];
        for (unsigned int v = 0; v < 8; ++v)
          {
            values[v] = .125 * vertices[v][c];
            largest   = std::max(largest, std::abs(vertices[v][c]));
          }
        // from values at −1 and 1 to coefficients, in each direction
        for (const unsigned int bit : {1, 2, 4})
          for (unsigned int v = 0; v < 8; ++v)
            if ((v & bit) == 0)
              {
                const double low = values[v], high = values[v | bit];
                values[v]       = high + low;
                values[v | bit] = high - low;
              }
        for (const unsigned int mode : {1, 2, 4})
          size = std::max(size, std::abs(values[mode]));
      }
    tolerance = 1e-12 * size + 4. * std::numeric_limits<double>::epsilon() * largest;
  }

  bool CellMap::is_valid() const
  {
    Matrix cofactors;
    const unsigned int n_points = is_affine() ? 1 : 8;
    for (unsigned int q = 0; q < n_points; ++q)
      if (!(determinant(jacobian(gauss_point(q)), cofactors) > 0.))
        return false;
    return true;
  }

  bool CellMap::is_affine() const
  {
    for (const auto &of_component : modes)
      for (const unsigned int mode : {3, 5, 6, 7})
        if (std::abs(of_component[mode]) > tolerance)
          return false;
    return true;
  }

  bool CellMap::is_box() const
  {
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        if (c != d && std::abs(modes[c][1 << d]) > tolerance)
          return false;
    return true;
  }

  bool CellMap::is_congruent(const CellMap &other) const
  {
    const double allowed = std::max(tolerance, other.tolerance);
    for (unsigned int c = 0; c < 3; ++c)
      for (const unsigned int mode : {1, 2, 4})
        if (std::abs(modes[c][mode] - other.modes[c][mode]) > allowed)
          return false;
    return true;
  }

  std::array<std::array<double, 3>, 3> CellMap::jacobian(
    const std::array<double, 3> &point) const
  {
    Matrix J;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const unsigned int d1 = (d + 1) % 3, d2 = (d + 2) % 3;
        const unsigned int s = 1 << d, s1 = 1 << d1, s2 = 1 << d2;
        for (unsigned int c = 0; c < 3; ++c)
          J[c][d] = modes[c][s] + point[d1] * modes[c][s | s1] +
                    point[d2] * modes[c][s | s2] + point[d1] * point[d2] * modes[c][7];
      }
    return J;
  }

  std::vector<double> affine_coefficients(const CellMap &map, const double lame_lambda,
                                          const double shear_modulus,
                                          const unsigned int n, const bool is_box)
  {
    // Matrices of a line: mass, stiffness, and β, each for the basis of
    // cell_kernel_affine.h.
    const double cell_mass[]  = {1. / 2., 1. / 6.};
    const double patch_mass[] = {1. / 8., 1. / 6., 1. / 24.};
    const double *const mass  = n == 2 ? cell_mass : patch_mass;
    const double stiffness[]  = {0., 1. / 2., 1. / 2.};
    const double beta         = n == 2 ? 1. / 2. : 1. / 4.;

    Matrix J = map.jacobian({0., 0., 0.}), cofactors;
    if (n == 3)
      for (auto &row : J)
        for (double &entry : row)
          entry *= 2.;
    const double det = determinant(J, cofactors);

    // gradients of the reference coordinates
    Matrix gradient;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int c = 0; c < 3; ++c)
        gradient[a][c] = cofactors[c][a] / det;
    Matrix energy[3][3];
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        energy[a][b] =
          elasticity(gradient[a], gradient[b], lame_lambda * det, shear_modulus * det);

    std::vector<double> result;
    const unsigned int n_modes = n * n * n;
    std::vector<Matrix> diagonal(n_modes, Matrix());
    for (unsigned int m = 0; m < n_modes; ++m)
      {
        const unsigned int i[] = {m % n, m / n % n, m / (n * n)};
        for (unsigned int a = 0; a < 3; ++a)
          {
            const double factor =
              stiffness[i[a]] * mass[i[(a + 1) % 3]] * mass[i[(a + 2) % 3]];
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int d = 0; d < 3; ++d)
                diagonal[m][c][d] += factor * energy[a][a][c][d];
          }
      }

    if (is_box)
      {
        for (unsigned int c = 0; c < 3; ++c)
          for (const Matrix &matrix : diagonal)
            result.push_back(matrix[c][c]);
        for (const bool is_shear : {false, true})
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int i = 0; i < n; ++i)
              {
                const unsigned int b = (a + 1) % 3, c = (a + 2) % 3;

                const double entry = is_shear ? energy[b][c][c][b] : energy[b][c][b][c];
                result.push_back(beta * beta * mass[i] * entry);
              }
      }
    else
      {
        for (const Matrix &matrix : diagonal)
          for (const double entry : {matrix[0][0], matrix[1][1], matrix[2][2],
                                     matrix[1][2], matrix[2][0], matrix[0][1]})
            result.push_back(entry);
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int i = 0; i < n; ++i)
            for (const auto &row : energy[(a + 1) % 3][(a + 2) % 3])
              for (const double entry : row)
                result.push_back(beta * beta * mass[i] * entry);
      }
    return result;
  }

  std::array<std::array<double, 9>, 8> diagonal_blocks(const CellMap &map,
                                                       const double lame_lambda,
                                                       const double shear_modulus)
  {
    static const std::array<std::array<std::array<double, 3>, 8>, 8> derivatives =
      shape_derivatives();

    // S = ∫ ∇φ ⊗ ∇φ, of which the block is (λ + μ) S + μ tr(S) I
    double S[8][3][3] = {};
    for (unsigned int q = 0; q < 8; ++q)
      {
        Matrix cofactors;
        const double inverse = 1. / determinant(map.jacobian(gauss_point(q)), cofactors);
        for (unsigned int v = 0; v < 8; ++v)
          {
            double gradient[3];
            for (unsigned int c = 0; c < 3; ++c)
              gradient[c] = derivatives[q][v][0] * cofactors[c][0] +
                            derivatives[q][v][1] * cofactors[c][1] +
                            derivatives[q][v][2] * cofactors[c][2];
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int d = 0; d < 3; ++d)
                S[v][c][d] += inverse * gradient[c] * gradient[d];
          }
      }

    std::array<std::array<double, 9>, 8> result;
    for (unsigned int v = 0; v < 8; ++v)
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          result[v][3 * c + d] =
            (lame_lambda + shear_modulus) * S[v][c][d] +
            (c == d ? shear_modulus * (S[v][0][0] + S[v][1][1] + S[v][2][2]) : 0.);
    return result;
  }
} // namespace stiction::cell_kernel
