#include "cell_patches.h"

#include <algorithm>
#include <limits>

namespace stiction::cell_kernel
{
  namespace
  {
    constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

    // Whether these eight cells share their nodes as a patch does.
    bool make_patch(const std::deque<CellNodes> &cells,
                    const std::array<std::uint32_t, 8> &children, PatchNodes &patch)
    {
      patch.fill(nothing);
      for (unsigned int child = 0; child < 8; ++child)
        for (unsigned int v = 0; v < 8; ++v)
          {
            const std::uint32_t node = cells[children[child]][v];
            std::uint32_t &in_patch  = patch[node_in_patch(child, v)];
            if (in_patch != nothing && in_patch != node)
              return false;
            in_patch = node;
          }
      return true;
    }

    // The cell that begins at each node, if only one does that is not taken.
    std::vector<std::uint32_t> cells_by_first_node(const std::deque<CellNodes> &cells,
                                                   const std::vector<bool> &is_taken)
    {
      std::uint32_t n_nodes = 0;
      for (const CellNodes &nodes : cells)
        n_nodes = std::max(n_nodes, *std::max_element(nodes.begin(), nodes.end()) + 1);
      std::vector<std::uint32_t> result(n_nodes, nothing);
      for (std::size_t cell = 0; cell < cells.size(); ++cell)
        if (!is_taken[cell])
          result[cells[cell][0]] = cell;
      return result;
    }
  } // namespace

  Patches find_patches(const std::deque<CellNodes> &cells)
  {
    Patches result;
    std::vector<bool> is_taken(cells.size(), false);
    std::size_t n_left = cells.size();
    PatchNodes patch;
    const auto take = [&](const std::array<std::uint32_t, 8> &children) {
      result.patches.push_back(patch);
      for (const std::uint32_t child : children)
        is_taken[child] = true;
      n_left -= 8;
    };

    for (std::size_t cell = 0; cell + 8 <= cells.size();)
      {
        std::array<std::uint32_t, 8> children;
        for (unsigned int child = 0; child < 8; ++child)
          children[child] = cell + child;
        const bool is_patch = make_patch(cells, children, patch);
        if (is_patch)
          take(children);
        cell += is_patch ? 8 : 1;
      }

    if (n_left >= 8)
      {
        const std::vector<std::uint32_t> by_first_node =
          cells_by_first_node(cells, is_taken);
        for (std::size_t cell = 0; cell < cells.size(); ++cell)
          {
            std::array<std::uint32_t, 8> children;
            bool are_left = !is_taken[cell];
            for (unsigned int child = 0; child < 8 && are_left; ++child)
              {
                children[child] = by_first_node[cells[cell][child]];
                are_left = children[child] != nothing && !is_taken[children[child]];
              }
            if (are_left && make_patch(cells, children, patch))
              take(children);
          }
      }

    result.cells.reserve(n_left);
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      if (!is_taken[cell])
        result.cells.push_back(cells[cell]);
    return result;
  }
} // namespace stiction::cell_kernel
