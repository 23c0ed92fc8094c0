#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/stiffness/nodal_constraint.h>

#include <deal.II/base/types.h>

#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace stiction
{
  class Materials;
  class MeshLevel;

  /// The coarse part of a multigrid cycle for a mesh without levels: the Galerkin
  /// products of K on background_grids(), made once for a mesh, and one V-cycle
  /// with them.
  ///
  /// Supports are springs on the grids, none of which has a node where a support is:
  /// Σ_i φ_k(x_i) [S_i + d_i (I − P_i)] at vertex k for a node i with the spring S_i, the
  /// projection P_i and the mean d_i of the diagonal of K. A changed contact set
  /// costs no more than that, and a dense factorisation on the last grid. Where another
  /// body is opposite to node i, these springs are between the two, in absolute
  /// displacements: (BP)ᵀ [S + d (I − P)] (BP), with B u = u_i − Σ_j N_ij u_j. The nodes
  /// j have the springs of the basis to the ground.
  ///
  /// Each rank has the products of its own cells; vectors of the grids are the same on
  /// all ranks, and every product is summed over them.
  class BackgroundMultigrid
  {
  public:
    using Interpolation = Eigen::SparseMatrix<float, Eigen::RowMajor>;

    /// @param mesh the mesh itself or the coarsest of its levels.
    /// @param unit of the stiffness, N/m.
    /// @param fixed one at prescribed unknowns.
    /// @param first_dofs of the nodes that supports may hold, the same on all
    ///   ranks. @param basis whose slaves they are, if it is not the identity.
    ///   Collective.
    BackgroundMultigrid(const Materials &materials, const MeshLevel &mesh, double unit,
                        const LA::Vector &fixed,
                        const std::vector<dealii::types::global_dof_index> &first_dofs,
                        const BasisTransformation &basis);
    ~BackgroundMultigrid();

    /// Takes supports for the nodes of the list, the same on all ranks.
    void set_supports(const NodalSupports &supports);

    /// Adds to x what a cycle makes of the residual r. Directions that are held are
    /// left to the caller. Collective.
    void correct(LA::VectorOf<float> &x, const LA::VectorOf<float> &r);

  private:
    class Grid;
    class SpringsBetweenBodies;

    /// x of a grid becomes one V-cycle for its b.
    void cycle(std::size_t grid);

    const double unit_;
    Interpolation to_mesh_;      ///< of the owned nodes from the first grid
    Interpolation to_supported_; ///< of the nodes of the list and of the masters
    std::vector<double> stiffness_of_supported_; ///< d_i, in units
    Eigen::VectorXf ground_;                     ///< of the masters, in units
    std::unique_ptr<SpringsBetweenBodies> between_;
    std::vector<std::unique_ptr<Grid>> grids_;
  };
} // namespace stiction
