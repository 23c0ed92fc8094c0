#pragma once

#include <deal.II/base/types.h>

#include <cstdint>
#include <vector>

namespace stiction
{
  class Body;

  /// The nodes of a mesh in an order that does not depend on how many ranks there
  /// are: as they are first met on a walk through the active cells along p4est's
  /// curve. Cells are dealt out to the ranks in pieces of the curve, and a node
  /// belongs to the lowest of its ranks, so that the nodes of a rank are a stretch of
  /// the order.
  class NodeOrder
  {
  public:
    /// Collective. The body must outlive the object.
    explicit NodeOrder(const Body &body);

    /// The place of the first node of this rank.
    std::uint64_t first() const { return first_; }

    /// The first unknowns of the nodes of this rank, in the order.
    const std::vector<dealii::types::global_dof_index> &first_dofs() const
    {
      return first_dofs_;
    }

    /// The places of nodes that all ranks name alike by their first unknowns.
    /// Collective.
    std::vector<std::uint64_t> places_of(
      const std::vector<dealii::types::global_dof_index> &nodes) const;

    /// The inverse of it. Collective.
    std::vector<dealii::types::global_dof_index> nodes_at(
      const std::vector<std::uint64_t> &places) const;

  private:
    const Body &body_;
    std::vector<dealii::types::global_dof_index> first_dofs_;
    std::uint64_t first_ = 0;
  };
} // namespace stiction
