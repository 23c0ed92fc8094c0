#pragma once

#include <cstddef>
#include <vector>

namespace stiction
{
  /// Sums over long vectors, of this rank. They are worked on in pieces that stay in the
  /// cache: all that is to be done with a piece is done at once.

  /// The size of a piece, a multiple of the three unknowns of a node.
  constexpr std::size_t piece_size = 1536;

  /// v_j · v for all j.
  std::vector<double> multiple_dot(const std::vector<const double *> &vectors,
                                   const double *v, std::size_t size);

  /// v -= Σ h_j v_j. @return v·v and v·r.
  std::vector<double> subtract_all(double *v, const std::vector<const double *> &vectors,
                                   const std::vector<double> &h, const double *r,
                                   std::size_t size);

  /// r -= a v. @return r·r and the sum of the norms at the nodes, of three unknowns each.
  std::vector<double> subtract(double *r, double a, const double *v, std::size_t size);
} // namespace stiction
