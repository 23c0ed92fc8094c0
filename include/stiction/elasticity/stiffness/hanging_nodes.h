#pragma once

#include <stiction/elasticity/mesh/mesh_level.h>

#include <cstddef>
#include <vector>

namespace stiction
{
  /// The hanging nodes of a level, for products cell by cell: the C and Cᵀ of CᵀKC, in
  /// place, for arrays of three numbers a local node.
  class HangingNodes
  {
  public:
    explicit HangingNodes(const MeshLevel &level)
      : nodes_(level.hanging_nodes())
    {
    }

    bool empty() const { return nodes_.empty(); }

    std::vector<MeshLevel::HangingNode>::const_iterator begin() const
    {
      return nodes_.begin();
    }
    std::vector<MeshLevel::HangingNode>::const_iterator end() const
    {
      return nodes_.end();
    }

    /// Gives hanging nodes the displacement that follows from the others.
    template<typename Number> void interpolate(Number *const u) const
    {
      for (const auto &[node, others] : nodes_)
        for (unsigned int c = 0; c < 3; ++c)
          {
            auto sum = Number(0.);
            for (const auto &[other, weight] : others)
              sum += static_cast<Number>(weight) * u[3 * std::size_t(other) + c];
            u[3 * std::size_t(node) + c] = sum;
          }
    }

    /// Hands the forces of hanging nodes on to the others; zero is left.
    template<typename Number> void distribute(Number *const f) const
    {
      for (const auto &[node, others] : nodes_)
        for (unsigned int c = 0; c < 3; ++c)
          {
            Number &force = f[3 * std::size_t(node) + c];
            for (const auto &[other, weight] : others)
              f[3 * std::size_t(other) + c] += static_cast<Number>(weight) * force;
            force = Number(0.);
          }
    }

  private:
    std::vector<MeshLevel::HangingNode> nodes_;
  };
} // namespace stiction
