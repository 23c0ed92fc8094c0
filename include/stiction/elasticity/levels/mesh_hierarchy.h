#pragma once

#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/levels/level_transfer.h>

#include <memory>
#include <vector>

namespace stiction
{
  class Body;

  /// The levels of a uniformly refined mesh, 0 the coarsest, and the transfers
  /// between them. The mesh itself is the last level, and the only one where it was
  /// refined locally. Below elements of degree 2 lie the trilinear ones of the same
  /// cells.
  class MeshHierarchy
  {
  public:
    /// @param levels_in_use false: the mesh itself is the only level, whatever
    ///   it was refined from. All arguments must outlive the object.
    ///   Collective.
    MeshHierarchy(const Body &body, const MeshLevel &mesh, bool levels_in_use = true);

    unsigned int n_levels() const
    {
      return static_cast<unsigned int>(coarser_.size()) + 1;
    }

    const MeshLevel &level(const unsigned int l) const
    {
      return l < coarser_.size() ? *coarser_[l] : mesh_;
    }

    /// The transfer between levels l − 1 and l > 0.
    const LevelTransfer &transfer(const unsigned int l) const
    {
      return *transfers_[l - 1];
    }

  private:
    const MeshLevel &mesh_;
    std::vector<std::unique_ptr<MeshLevel>> coarser_;
    std::vector<std::unique_ptr<LevelTransfer>> transfers_;
  };
} // namespace stiction
