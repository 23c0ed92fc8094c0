#pragma once

#include <stiction/elasticity/kernels/cell_stiffness.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/stiffness/element_matrices.h>
#include <stiction/elasticity/stiffness/hanging_nodes.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace stiction
{
  class Materials;

  /// The product with the stiffness matrix K of a level of the mesh without any
  /// boundary condition, cell by cell: integrated in every product for trilinear cells
  /// of simple materials, else by element matrices. With hanging nodes it is CᵀKC: what a
  /// vector has there is ignored, and the product is zero there.
  template<typename Number> class StiffnessOperator
  {
  public:
    using Vector = LA::VectorOf<Number>;

    /// @param unit of the entries of K, in N/m. The level must outlive the
    ///   object.
    StiffnessOperator(const MeshLevel &level, const Materials &materials,
                      double unit = 1.);

    const MeshLevel &level() const { return level_; }

    /// dst = K src, both made by the level's zero_vector(). Collective.
    void vmult(Vector &dst, const Vector &src) const;

    /// The 3 × 3 blocks of the owned nodes on the diagonal, by rows: nine
    /// numbers a node; zero at hanging nodes. Collective.
    std::vector<Number> diagonal_blocks() const;

  private:
    /// dst += K src without hanging nodes, of local nodes.
    void add_product(Number *dst, const Number *src) const;

    /// What hanging nodes add to the diagonal blocks of the nodes they depend on.
    void find_hanging_blocks(const Materials &materials, double unit);

    const MeshLevel &level_;
    CellStiffness<Number> cells_;
    ElementMatrices<Number> elements_;
    HangingNodes hanging_;
    std::vector<std::pair<unsigned int, Eigen::Matrix3d>> hanging_blocks_;
    mutable std::vector<Number> interpolated_; ///< src with values at hanging nodes
  };
} // namespace stiction
