#include <stiction/elasticity/multigrid/background_grids.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

namespace stiction
{
  namespace
  {
    using Point3 = std::array<double, 3>;
    using Place  = std::array<int, 3>; // of a vertex, in edges of the smallest cubes
    using Interpolation = Eigen::SparseMatrix<float, Eigen::RowMajor>;

    // A grid of so few vertices is the last one.
    constexpr std::size_t few_vertices = 130;

    // Cells so many times as large as the small ones get cubes of their own size.
    constexpr double graded = 1.9;

    // A cube of a lattice: those of lattice k have edges of 2^k of the smallest.
    struct Cube
    {
      int lattice = 0;
      Place index{};

      bool operator==(const Cube &other) const
      {
        return lattice == other.lattice && index == other.index;
      }
      bool operator<(const Cube &other) const
      {
        return std::tie(lattice, index) < std::tie(other.lattice, other.index);
      }

      Cube parent() const
      {
        return {lattice + 1, {{index[0] >> 1, index[1] >> 1, index[2] >> 1}}};
      }

      Place corner(const unsigned int v) const
      {
        Place place;
        for (unsigned int c = 0; c < 3; ++c)
          place[c] = (index[c] + static_cast<int>(v >> c & 1)) << lattice;
        return place;
      }
    };

    // Sets of things that are one, with the smallest as their name.
    class UnionFind
    {
    public:
      explicit UnionFind(const std::size_t n)
        : parent_(n)
      {
        std::iota(parent_.begin(), parent_.end(), 0u);
      }

      unsigned int find(unsigned int i)
      {
        while (parent_[i] != i)
          i = parent_[i] = parent_[parent_[i]];
        return i;
      }

      void unite(unsigned int a, unsigned int b)
      {
        a                       = find(a);
        b                       = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
      }

      // Numbers the sets in the order of their names; number by thing.
      std::vector<unsigned int> number(unsigned int &n_sets)
      {
        std::vector<unsigned int> numbers(parent_.size());
        n_sets = 0;
        for (unsigned int i = 0; i < parent_.size(); ++i)
          numbers[i] = find(i) == i ? n_sets++ : numbers[find(i)];
        return numbers;
      }

    private:
      std::vector<unsigned int> parent_;
    };

    // Lists by number: those of i are entries[begin[i]] to entries[begin[i + 1]].
    struct Lists
    {
      std::vector<unsigned int> begin, entries;

      // Of pairs (number, entry).
      template<typename Pairs>
      Lists(const std::size_t n, const std::size_t n_pairs, const Pairs &pair)
        : begin(n + 1, 0)
        , entries(n_pairs)
      {
        for (std::size_t k = 0; k < n_pairs; ++k)
          ++begin[pair(k).first + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        std::vector<unsigned int> next(begin.begin(), begin.end() - 1);
        for (std::size_t k = 0; k < n_pairs; ++k)
          entries[next[pair(k).first]++] = pair(k).second;
      }
    };

    using Links = std::vector<std::pair<unsigned int, unsigned int>>;

    // What a grid is made of: pieces of the body, each with eight points (nodes of a
    // cell, vertices of a cube of the grid before) and the cube that it goes to.
    struct Pieces
    {
      std::vector<Cube> cubes;
      std::vector<std::array<unsigned int, 8>> points;
      Links links; // pieces in which one cell of the mesh lies
    };

    // A grid: cubes with the part of the body in them, and their vertices.
    struct Grid
    {
      std::vector<Cube> cubes;
      std::vector<std::array<unsigned int, 8>> vertices;
      Links links;                        // as of pieces, of the cubes
      std::vector<Place> places;          // of the vertices
      std::vector<unsigned int> of_piece; // the cube of each piece
      Lists pieces_at;                    // by point
    };

    // The pieces in one cube that share points or a cell are one.
    void join_pieces(const Pieces &pieces, Grid &grid)
    {
      UnionFind together(pieces.cubes.size());
      const Lists &at = grid.pieces_at;
      std::vector<unsigned int> others; // a piece of each cube at the point
      for (std::size_t p = 0; p + 1 < at.begin.size(); ++p)
        {
          others.clear();
          for (unsigned int k = at.begin[p]; k < at.begin[p + 1]; ++k)
            {
              const unsigned int piece = at.entries[k];
              const auto same =
                std::find_if(others.begin(), others.end(), [&](const unsigned int other) {
                  return pieces.cubes[other] == pieces.cubes[piece];
                });
              if (same == others.end())
                others.push_back(piece);
              else
                together.unite(piece, *same);
            }
        }
      for (const auto &[a, b] : pieces.links)
        if (pieces.cubes[a] == pieces.cubes[b])
          together.unite(a, b);

      unsigned int n_cubes = 0;
      grid.of_piece        = together.number(n_cubes);
      grid.cubes.resize(n_cubes);
      for (std::size_t i = 0; i < pieces.cubes.size(); ++i)
        grid.cubes[grid.of_piece[i]] = pieces.cubes[i];
      for (const auto &[a, b] : pieces.links)
        if (const auto [low, high] = std::minmax(grid.of_piece[a], grid.of_piece[b]);
            low != high)
          grid.links.emplace_back(low, high);
      std::sort(grid.links.begin(), grid.links.end());
      grid.links.erase(std::unique(grid.links.begin(), grid.links.end()),
                       grid.links.end());
    }

    // Corners at one place of cubes that hang together are one vertex.
    class Corners
    {
    public:
      explicit Corners(const Grid &grid)
        : grid_(grid)
        , same_(8 * grid.cubes.size())
      {
      }

      void unite(std::vector<unsigned int> &cubes)
      {
        std::sort(cubes.begin(), cubes.end());
        cubes.erase(std::unique(cubes.begin(), cubes.end()), cubes.end());
        if (cubes.size() < 2)
          return;
        corners_.clear();
        for (const unsigned int cube : cubes)
          for (unsigned int v = 0; v < 8; ++v)
            corners_.emplace_back(grid_.cubes[cube].corner(v), 8 * cube + v);
        std::sort(corners_.begin(), corners_.end());
        for (std::size_t k = 1; k < corners_.size(); ++k)
          if (corners_[k].first == corners_[k - 1].first)
            same_.unite(corners_[k].second, corners_[k - 1].second);
      }

      void number(Grid &grid)
      {
        unsigned int n_vertices                 = 0;
        const std::vector<unsigned int> numbers = same_.number(n_vertices);
        grid.places.resize(n_vertices);
        grid.vertices.resize(grid.cubes.size());
        for (std::size_t k = 0; k < numbers.size(); ++k)
          {
            grid.vertices[k / 8][k % 8] = numbers[k];
            grid.places[numbers[k]]     = grid.cubes[k / 8].corner(k % 8);
          }
      }

    private:
      const Grid &grid_;
      UnionFind same_;
      std::vector<std::pair<Place, unsigned int>> corners_;
    };

    Grid make_grid(const Pieces &pieces, const std::size_t n_points)
    {
      const std::size_t n = pieces.cubes.size();
      Grid grid{{}, {}, {}, {}, {}, Lists(n_points, 8 * n, [&](const std::size_t k) {
                  return std::make_pair(pieces.points[k / 8][k % 8],
                                        static_cast<unsigned int>(k / 8));
                })};
      join_pieces(pieces, grid);

      Corners corners(grid);
      std::vector<unsigned int> cubes;
      for (const auto &[a, b] : grid.links)
        {
          cubes = {a, b};
          corners.unite(cubes);
        }
      corners.number(grid);
      return grid;
    }

    // Trilinear interpolation of points from the vertices of their cubes.
    //
    // @param cube_of, place_of of a point, the place in edges of the smallest cubes.
    template<typename CubeOf, typename PlaceOf>
    Interpolation interpolate(const Grid &grid, const std::size_t n_points,
                              const CubeOf &cube_of, const PlaceOf &place_of)
    {
      std::vector<Eigen::Triplet<float>> weights;
      for (std::size_t p = 0; p < n_points; ++p)
        {
          const unsigned int number = cube_of(p);
          const Cube &cube          = grid.cubes[number];
          const Point3 place        = place_of(p);
          for (unsigned int v = 0; v < 8; ++v)
            {
              double weight = 1.;
              for (unsigned int c = 0; c < 3; ++c)
                {
                  const double x = std::ldexp(place[c], -cube.lattice) - cube.index[c];
                  weight *= (v >> c & 1) != 0 ? x : 1. - x;
                }
              if (weight != 0.)
                weights.emplace_back(p, grid.vertices[number][v], weight);
            }
        }
      Interpolation matrix(n_points, grid.places.size());
      matrix.setFromTriplets(weights.begin(), weights.end());
      return matrix;
    }

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

    // The smallest cubes, and where the nodes are in them.
    class Lattices
    {
    public:
      Lattices(const std::vector<Point3> &nodes,
               const std::vector<std::array<unsigned int, 8>> &cells)
        : nodes_(nodes)
        , lattice_of_(nodes.size(), 0)
      {
        std::vector<double> sizes;
        for (const auto &cell : cells)
          sizes.push_back(size_of(nodes, cell));
        const bool is_graded = quantile(sizes, 0.95) > graded * quantile(sizes, 0.05);
        edge_                = 2. * quantile(sizes, is_graded ? 0.01 : 0.5);
        if (is_graded)
          choose_lattices(cells, sizes);

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

      Point3 place(const std::size_t node) const
      {
        Point3 place;
        for (unsigned int c = 0; c < 3; ++c)
          place[c] = (nodes_[node][c] - origin_[c]) / edge_;
        return place;
      }

      Cube cube(const std::size_t node) const
      {
        const Point3 x = place(node);
        Cube cube{lattice_of_[node], {}};
        for (unsigned int c = 0; c < 3; ++c)
          cube.index[c] =
            std::clamp(static_cast<int>(std::floor(x[c])), 0, n_[c] - 1) >> cube.lattice;
        return cube;
      }

    private:
      // Each node gets cubes of about twice the mean size of the cells around it.
      void choose_lattices(const std::vector<std::array<unsigned int, 8>> &cells,
                           const std::vector<double> &sizes)
      {
        std::vector<std::pair<double, int>> sums(nodes_.size());
        for (std::size_t e = 0; e < cells.size(); ++e)
          for (const unsigned int node : cells[e])
            {
              sums[node].first += sizes[e];
              ++sums[node].second;
            }
        for (std::size_t i = 0; i < nodes_.size(); ++i)
          lattice_of_[i] =
            std::max(0, static_cast<int>(std::lround(std::log2(
                          2. * sums[i].first / (std::max(sums[i].second, 1) * edge_)))));
      }

      const std::vector<Point3> &nodes_;
      std::vector<int> lattice_of_;
      double edge_ = 0.;
      Point3 origin_{};
      Place n_{};
    };
  } // namespace

  std::vector<Interpolation> background_grids(
    const std::vector<Point3> &nodes,
    const std::vector<std::array<unsigned int, 8>> &cells)
  {
    const Lattices lattices(nodes, cells);
    std::vector<Cube> cubes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      cubes.push_back(lattices.cube(i));

    // a cell is a piece of every cube in which it has a node
    Pieces pieces;
    for (const auto &cell : cells)
      {
        std::array<Cube, 8> touched;
        for (unsigned int v = 0; v < 8; ++v)
          touched[v] = cubes[cell[v]];
        std::sort(touched.begin(), touched.end());
        const auto end   = std::unique(touched.begin(), touched.end());
        const auto first = static_cast<unsigned int>(pieces.cubes.size());
        for (auto cube = touched.begin(); cube != end; ++cube)
          {
            const auto piece = static_cast<unsigned int>(pieces.cubes.size());
            for (unsigned int other = first; other < piece; ++other)
              pieces.links.emplace_back(other, piece);
            pieces.cubes.push_back(*cube);
            pieces.points.push_back(cell);
          }
      }

    std::vector<Interpolation> all;
    Grid grid = make_grid(pieces, nodes.size());
    all.push_back(interpolate(
      grid, nodes.size(),
      [&](const std::size_t i) {
        const Lists &at = grid.pieces_at;
        for (unsigned int k = at.begin[i]; k < at.begin[i + 1]; ++k)
          if (pieces.cubes[at.entries[k]] == cubes[i])
            return grid.of_piece[at.entries[k]];
        return 0u; // a node of no cell
      },
      [&](const std::size_t i) { return lattices.place(i); }));

    while (grid.places.size() > few_vertices)
      {
        const std::vector<Place> places = std::move(grid.places);
        pieces.points                   = std::move(grid.vertices);
        pieces.links                    = std::move(grid.links);
        pieces.cubes.clear();
        for (const Cube &cube : grid.cubes)
          pieces.cubes.push_back(cube.parent());
        Grid coarse = make_grid(pieces, places.size());
        if (coarse.places.size() > 0.9 * static_cast<double>(places.size()))
          break;
        all.push_back(interpolate(
          coarse, places.size(),
          [&](const std::size_t i) {
            const Lists &at    = coarse.pieces_at;
            unsigned int small = coarse.of_piece[at.entries[at.begin[i]]];
            for (unsigned int k = at.begin[i] + 1; k < at.begin[i + 1]; ++k)
              {
                const unsigned int other = coarse.of_piece[at.entries[k]];
                if (coarse.cubes[other].lattice < coarse.cubes[small].lattice)
                  small = other;
              }
            return small;
          },
          [&](const std::size_t i) {
            return Point3{
              {double(places[i][0]), double(places[i][1]), double(places[i][2])}};
          }));
        grid = std::move(coarse);
      }
    return all;
  }
} // namespace stiction
