#include <stiction/elasticity/linear_algebra/long_vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    using Chunk      = Eigen::Map<Eigen::VectorXd>;
    using ConstChunk = Eigen::Map<const Eigen::VectorXd>;

    Eigen::Index size_at(const std::size_t begin, const std::size_t size)
    {
      return static_cast<Eigen::Index>(std::min(piece_size, size - begin));
    }
  } // namespace

  std::vector<double> multiple_dot(const std::vector<const double *> &vectors,
                                   const double *const v, const std::size_t size)
  {
    std::vector<double> products(vectors.size(), 0.);
    for (std::size_t b = 0; b < size; b += piece_size)
      {
        const Eigen::Index n = size_at(b, size);
        for (std::size_t j = 0; j < vectors.size(); ++j)
          products[j] += ConstChunk(vectors[j] + b, n).dot(ConstChunk(v + b, n));
      }
    return products;
  }

  std::vector<double> subtract_all(double *const v,
                                   const std::vector<const double *> &vectors,
                                   const std::vector<double> &h, const double *const r,
                                   const std::size_t size)
  {
    std::vector<double> products(2, 0.);
    for (std::size_t b = 0; b < size; b += piece_size)
      {
        const Eigen::Index n = size_at(b, size);
        Chunk chunk(v + b, n);
        for (std::size_t j = 0; j < vectors.size(); ++j)
          chunk -= h[j] * ConstChunk(vectors[j] + b, n);
        products[0] += chunk.squaredNorm();
        products[1] += chunk.dot(ConstChunk(r + b, n));
      }
    return products;
  }

  std::vector<double> subtract(double *const r, const double a, const double *const v,
                               const std::size_t size)
  {
    std::vector<double> sums(2, 0.);
    for (std::size_t k = 0; k < size; k += 3)
      {
        double square = 0.;
        for (std::size_t c = k; c < k + 3; ++c)
          {
            r[c] -= a * v[c];
            square += r[c] * r[c];
          }
        sums[0] += square;
        sums[1] += std::sqrt(square);
      }
    return sums;
  }
} // namespace stiction
