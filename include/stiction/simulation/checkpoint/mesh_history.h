#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include <deal.II/grid/cell_id.h>

namespace stiction
{
  class Body;

  /// Which cells were cut in each adaptive refinement. To cut them again gives the
  /// same mesh with the same numbers, which the mesh alone would not.
  class MeshHistory
  {
  public:
    /// No refinement.
    MeshHistory() = default;

    /// @param words of all ranks, one after the other.
    explicit MeshHistory(const std::vector<std::uint64_t> &words);

    /// Takes note of what Body::refine() is going to do.
    void add(const std::vector<bool> &is_cut, const Body &body);

    /// Refines a body that was not refined yet. Collective.
    void repeat_on(Body &body) const;

    /// The cells of this rank, three words each.
    std::vector<std::uint64_t> words() const;

  private:
    using Cells = std::set<dealii::CellId>;
    std::vector<Cells> cut_; ///< one for each refinement
  };
} // namespace stiction
