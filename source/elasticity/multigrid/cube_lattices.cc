#include "cube_lattices.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stiction
{
  namespace
  {
    using Point3 = std::array<double, 3>;

    // Cells so many times as large as the small ones get cubes of their own size.
    constexpr double graded = 1.9;

    // |det| of the map at the centre of a cell is about its volume.
    double size_of(const std::vector<Point3> &nodes,
                   const std::array<unsigned int, 8> &cell)
    {
      std::array<Point3, 3> edges{};
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int c = 0; c < 3; ++c)
            edges[d][c] += ((v >> d & 1) != 0 ? 0.25 : -0.25) * nodes[cell[v]][c];
      const auto &[a, b, c] = edges;
      return std::cbrt(std::abs(a[0] * (b[1] * c[2] - b[2] * c[1]) +
                                a[1] * (b[2] * c[0] - b[0] * c[2]) +
                                a[2] * (b[0] * c[1] - b[1] * c[0])));
    }

    double quantile(std::vector<double> values, const double part)
    {
      const auto place =
        values.begin() +
        static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
      std::nth_element(values.begin(), place, values.end());
      return *place;
    }
  } // namespace

  CubeLattices::CubeLattices(const std::vector<Point3> &nodes,
                             const std::vector<std::array<unsigned int, 8>> &cells)
    : nodes_(nodes)
    , lattice_of_(nodes.size(), 0)
  {
    std::vector<double> sizes;
    for (const auto &cell : cells)
      sizes.push_back(size_of(nodes, cell));
    const bool is_graded = quantile(sizes, 0.95) > graded * quantile(sizes, 0.05);
    edge_                = 2. * quantile(sizes, is_graded ? 0.01 : 0.5);
    choose_lattices(cells, sizes, is_graded ? 1. : graded);

    for (unsigned int c = 0; c < 3; ++c)
      {
        double low = nodes[0][c], high = low;
        for (const Point3 &node : nodes)
          {
            low  = std::min(low, node[c]);
            high = std::max(high, node[c]);
          }
        n_[c]      = std::max(1, static_cast<int>(std::ceil((high - low) / edge_)));
        origin_[c] = 0.5 * (low + high - n_[c] * edge_);
      }
  }

  std::array<double, 3> CubeLattices::place(const std::size_t node) const
  {
    Point3 place;
    for (unsigned int c = 0; c < 3; ++c)
      place[c] = (nodes_[node][c] - origin_[c]) / edge_;
    return place;
  }

  Cube CubeLattices::cube(const std::size_t node) const
  {
    const Point3 x = place(node);
    Cube cube{lattice_of_[node], {}};
    for (unsigned int c = 0; c < 3; ++c)
      cube.index[c] =
        std::clamp(static_cast<int>(std::floor(x[c])), 0, n_[c] - 1) >> cube.lattice;
    return cube;
  }

  void CubeLattices::choose_lattices(
    const std::vector<std::array<unsigned int, 8>> &cells,
    const std::vector<double> &sizes, const double small)
  {
    std::vector<std::pair<double, int>> sums(nodes_.size());
    for (std::size_t e = 0; e < cells.size(); ++e)
      for (const unsigned int node : cells[e])
        {
          sums[node].first += sizes[e];
          ++sums[node].second;
        }
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      {
        const double size = 2. * sums[i].first / (std::max(sums[i].second, 1) * edge_);
        if (size > small)
          lattice_of_[i] = static_cast<int>(std::lround(std::log2(size)));
      }
  }
} // namespace stiction
