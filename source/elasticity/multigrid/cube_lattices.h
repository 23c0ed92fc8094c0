#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace stiction
{
  /// A cube of a lattice: those of lattice k have edges of 2^k of the smallest.
  struct Cube
  {
    /// Of a vertex, in edges of the smallest cubes.
    using Place = std::array<int, 3>;

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

  /// The smallest cubes behind a mesh, and where its nodes are in them.
  class CubeLattices
  {
  public:
    /// @param nodes their places, m. @param cells as of background_grids().
    CubeLattices(const std::vector<std::array<double, 3>> &nodes,
                 const std::vector<std::array<unsigned int, 8>> &cells);

    /// Of a node, in edges of the smallest cubes.
    std::array<double, 3> place(std::size_t node) const;

    /// The cube a node is in: of the lattice that suits the cells around it.
    Cube cube(std::size_t node) const;

  private:
    /// Each node gets cubes of about twice the mean size of the cells around it, or the
    /// smallest ones if that is up to @p small times their edge.
    void choose_lattices(const std::vector<std::array<unsigned int, 8>> &cells,
                         const std::vector<double> &sizes, double small);

    const std::vector<std::array<double, 3>> &nodes_;
    std::vector<int> lattice_of_;
    double edge_ = 0.;
    std::array<double, 3> origin_{};
    Cube::Place n_{};
  };
} // namespace stiction
