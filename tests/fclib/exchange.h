#pragma once

// A contact problem with a known solution, for both sides of the exchange with
// FCLIB: plain numbers, interleaved (ν, t1, t2) as FCLIB has them.

#include <array>
#include <cmath>

namespace exchange
{
  constexpr int m = 3;
  constexpr int n = 3 * m;

  // A stick node, a slip node, an open node.
  constexpr std::array<double, m> mu{{0.3, 0.5, 0.2}};
  constexpr std::array<double, n> reaction{{2., 0.3, -0.4, 3., 0.9, 1.2, 0., 0., 0.}};
  // the remaining gap; −slip, which is against the force
  constexpr std::array<double, n> velocity{
    {0., 0., 0., 0., -0.06, -0.08, 0.5, 0.1, -0.2}};

  // Symmetric, diagonally dominant, no two entries of a row the same.
  inline double W(const int row, const int column)
  {
    const int small = row < column ? row : column;
    const int large = row < column ? column : row;
    return row == column ? 5. + 0.1 * row : 0.3 * std::sin(1. + 2. * small + 0.7 * large);
  }

  // q = u − W r
  inline std::array<double, n> q()
  {
    std::array<double, n> result = velocity;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        result[i] -= W(i, j) * reaction[j];
    return result;
  }
} // namespace exchange
