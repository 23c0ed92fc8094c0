#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

namespace stiction::cell_kernel
{
  using CellNodes  = std::array<std::uint32_t, 8>;
  using PatchNodes = std::array<std::uint32_t, 27>;

  /// Cells of one shape, arranged in 2×2×2 patches and what is left.
  struct Patches
  {
    std::vector<PatchNodes> patches;
    std::vector<CellNodes> cells;
  };

  /// Where in its patch a child has a node.
  constexpr unsigned int node_in_patch(const unsigned int child, const unsigned int node)
  {
    return (child & 1) + (node & 1) + 3 * ((child >> 1 & 1) + (node >> 1 & 1)) +
           9 * ((child >> 2 & 1) + (node >> 2 & 1));
  }

  /// Finds patches: first eight cells that follow each other, as children of a
  /// cell do, then any others. All nodes are numbered lexicographically.
  Patches find_patches(const std::deque<CellNodes> &cells);
} // namespace stiction::cell_kernel
