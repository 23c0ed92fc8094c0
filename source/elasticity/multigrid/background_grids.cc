#include "cube_lattices.h"

#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/multigrid/background_grids.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace stiction
{
  namespace
  {
    using Point3        = std::array<double, 3>;
    using Place         = Cube::Place;
    using Interpolation = Eigen::SparseMatrix<float, Eigen::RowMajor>;

    // A grid of so few vertices is the last one.
    constexpr std::size_t few_vertices = 130;

    using Sets = boost::disjoint_sets_with_storage<>; // of things that are one

    // Numbers the sets in the order of their first things; number by thing.
    std::vector<unsigned int> number(Sets &sets, const std::size_t n_things,
                                     unsigned int &n_sets)
    {
      constexpr auto none = static_cast<unsigned int>(-1);
      std::vector<unsigned int> of_set(n_things, none), numbers(n_things);
      n_sets = 0;
      for (std::size_t i = 0; i < n_things; ++i)
        {
          unsigned int &number = of_set[sets.find_set(i)];
          if (number == none)
            number = n_sets++;
          numbers[i] = number;
        }
      return numbers;
    }

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
      Sets together(pieces.cubes.size());
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
                together.union_set(piece, *same);
            }
        }
      for (const auto &[a, b] : pieces.links)
        if (pieces.cubes[a] == pieces.cubes[b])
          together.union_set(a, b);

      unsigned int n_cubes = 0;
      grid.of_piece        = number(together, pieces.cubes.size(), n_cubes);
      grid.cubes.resize(n_cubes);
      for (std::size_t i = 0; i < pieces.cubes.size(); ++i)
        grid.cubes[grid.of_piece[i]] = pieces.cubes[i];
      for (const auto &[a, b] : pieces.links)
        if (const auto [low, high] = std::minmax(grid.of_piece[a], grid.of_piece[b]);
            low != high)
          grid.links.emplace_back(low, high);
      sort_once(grid.links);
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
        sort_once(cubes);
        if (cubes.size() < 2)
          return;
        corners_.clear();
        for (const unsigned int cube : cubes)
          for (unsigned int v = 0; v < 8; ++v)
            corners_.emplace_back(grid_.cubes[cube].corner(v), 8 * cube + v);
        std::sort(corners_.begin(), corners_.end());
        for (std::size_t k = 1; k < corners_.size(); ++k)
          if (corners_[k].first == corners_[k - 1].first)
            same_.union_set(corners_[k].second, corners_[k - 1].second);
      }

      void number(Grid &grid)
      {
        unsigned int n_vertices = 0;
        const std::vector<unsigned int> numbers =
          stiction::number(same_, 8 * grid.cubes.size(), n_vertices);
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
      Sets same_;
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
      Interpolation matrix(static_cast<Eigen::Index>(n_points),
                           static_cast<Eigen::Index>(grid.places.size()));
      matrix.setFromTriplets(weights.begin(), weights.end());
      return matrix;
    }
  } // namespace

  std::vector<Interpolation> background_grids(
    const std::vector<Point3> &nodes,
    const std::vector<std::array<unsigned int, 8>> &cells)
  {
    const CubeLattices lattices(nodes, cells);
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
        if (10 * coarse.places.size() > 9 * places.size())
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
