#include <stiction/elasticity/stiffness/element_matrices.h>

#include <algorithm>

namespace stiction
{
  template<typename Number>
  void ElementMatrices<Number>::add(const std::vector<unsigned int> &nodes,
                                    const dealii::FullMatrix<double> &matrix)
  {
    if (empty() || !(matrix == last_))
      {
        last_ = matrix;
        matrices_.emplace_back(matrix.m(), matrix.n());
        for (unsigned int i = 0; i < matrix.m(); ++i)
          for (unsigned int j = 0; j < matrix.n(); ++j)
            matrices_.back()(i, j) = static_cast<Number>(matrix(i, j));
        ends_.push_back(ends_.empty() ? 0 : ends_.back());
      }
    cells_.insert(cells_.end(), nodes.begin(), nodes.end());
    ++ends_.back();
  }

  template<typename Number>
  void ElementMatrices<Number>::add_product(Number *dst, const Number *src) const
  {
    // cells with the same matrix go together through the cache
    constexpr std::size_t most = 8;
    const std::size_t n        = n_nodes();
    Matrix from(3 * n, most), to(3 * n, most);
    std::size_t cell = 0;
    for (std::size_t m = 0; m < matrices_.size(); ++m)
      while (cell < ends_[m])
        {
          const std::size_t together = std::min(most, ends_[m] - cell);
          const unsigned int *nodes  = &cells_[n * cell];
          for (std::size_t k = 0; k < together; ++k)
            for (std::size_t i = 0; i < n; ++i)
              std::copy_n(src + 3 * std::size_t(nodes[n * k + i]), 3, &from(3 * i, k));
          if (together == 1)
            to.col(0).noalias() = matrices_[m] * from.col(0);
          else
            to.leftCols(together).noalias() = matrices_[m] * from.leftCols(together);
          for (std::size_t k = 0; k < together; ++k)
            for (std::size_t i = 0; i < n; ++i)
              for (unsigned int c = 0; c < 3; ++c)
                dst[3 * std::size_t(nodes[n * k + i]) + c] += to(3 * i + c, k);
          cell += together;
        }
  }

  template<typename Number>
  void ElementMatrices<Number>::add_diagonal_blocks(Number *dst) const
  {
    const std::size_t n = n_nodes();
    std::size_t cell    = 0;
    for (std::size_t m = 0; m < matrices_.size(); ++m)
      for (; cell < ends_[m]; ++cell)
        for (std::size_t i = 0; i < n; ++i)
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              dst[9 * std::size_t(cells_[n * cell + i]) + 3 * a + b] +=
                matrices_[m](3 * i + a, 3 * i + b);
  }

  template class ElementMatrices<float>;
  template class ElementMatrices<double>;
} // namespace stiction
