#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <mpi.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace dealii
{
  template<int dim, int spacedim> class DoFHandler;
}
namespace dealii::Utilities::MPI
{
  class Partitioner;
}

namespace stiction
{
  class Body;
  struct HexahedralCell;

  /// The nodes of one level of the mesh as a rank sees them: its own, and the
  /// ghosts that its cells and the children of its cells one level up have; all
  /// that the body finds relevant where there are hanging nodes or degree 2.
  ///
  /// Vectors of a level hold three numbers a node, its own nodes first, so a
  /// local node i has the entries 3i, 3i + 1, 3i + 2.
  class MeshLevel
  {
  public:
    /// The active cells: the mesh itself.
    explicit MeshLevel(const Body &body);

    /// The vertices of the cells of one refinement level, active or not. The mesh must
    /// be uniform.
    MeshLevel(const Body &body, unsigned int level);

    const Body &body() const { return body_; }

    /// Whether the nodes are the vertices of the cells: not so for the mesh itself if
    /// its elements are of degree 2.
    bool is_trilinear() const;

    MPI_Comm communicator() const;

    const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &partitioner() const
    {
      return partitioner_;
    }

    unsigned int n_owned_nodes() const;

    /// Owned ones and ghosts.
    unsigned int n_local_nodes() const;

    /// Where the owned nodes are, m.
    std::vector<dealii::Point<3>> node_positions() const;

    /// The number of unknowns on all ranks.
    dealii::types::global_dof_index n_dofs() const;

    /// The local node with this unknown as its first; it must be known here.
    unsigned int local_node(dealii::types::global_dof_index first_dof) const;

    /// The first unknown of a local node.
    dealii::types::global_dof_index first_dof(unsigned int local_node) const;

    /// A vector of zeros with room for the ghosts.
    template<typename Number> LA::VectorOf<Number> zero_vector() const;

    /// Calls back with every cell this rank owns, for trilinear elements alone,
    /// with its material id but without its material, see Materials::assign().
    void for_each_cell(const std::function<void(const HexahedralCell &)> &callback) const;

    /// Calls back with the nodes of every cell that this rank owns, in lexicographic
    /// order: 8 of trilinear elements, 27 of degree 2.
    void for_each_node_list(
      const std::function<void(const std::vector<unsigned int> &)> &callback) const;

    /// A node whose displacement is Σ weight × that of others, by local nodes.
    struct HangingNode
    {
      unsigned int node;
      std::vector<std::pair<unsigned int, double>> others;
    };

    /// Those of the cells this rank owns.
    std::vector<HangingNode> hanging_nodes() const;

  private:
    void make_partitioner();

    template<typename Callback> void for_each_own_cell(const Callback &callback) const;

    const Body &body_;
    const bool is_active_;
    const unsigned int level_;
    const dealii::DoFHandler<3, 3> &dof_handler_;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  };
} // namespace stiction
