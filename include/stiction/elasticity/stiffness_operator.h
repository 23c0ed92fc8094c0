#ifndef stiction_elasticity_stiffness_operator_h
#define stiction_elasticity_stiffness_operator_h

#include <stiction/elasticity/cell_stiffness.h>
#include <stiction/elasticity/linear_algebra.h>

#include <vector>

namespace stiction
{
  class Materials;
  class MeshLevel;

  /// The product with the stiffness matrix K of a level of the mesh, without a
  /// matrix and without any boundary condition.
  template<typename Number>
  class StiffnessOperator
  {
  public:
    using Vector = LA::VectorOf<Number>;

    /// @param unit of the entries of K, in N/m. The level must outlive the
    ///   object.
    StiffnessOperator(const MeshLevel &level,
                      const Materials &materials,
                      double unit = 1.);

    const MeshLevel &
    level() const
    {
      return level_;
    }

    /// dst = K src, both made by the level's zero_vector(). Collective.
    void
    vmult(Vector &dst, const Vector &src) const;

    /// The 3 × 3 blocks of the owned nodes on the diagonal, by rows: nine
    /// numbers a node. Collective.
    std::vector<Number>
    diagonal_blocks() const;

  private:
    const MeshLevel &level_;
    CellStiffness<Number> cells_;
  };
} // namespace stiction

#endif
