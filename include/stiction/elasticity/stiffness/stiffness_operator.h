#ifndef stiction_elasticity_stiffness_stiffness_operator_h
#define stiction_elasticity_stiffness_stiffness_operator_h

#include <stiction/elasticity/kernels/cell_stiffness.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <memory>
#include <vector>

namespace stiction
{
  class Materials;
  class MeshLevel;

  /// The product with the stiffness matrix K of a level of the mesh without any
  /// boundary condition: cell by cell without a matrix, or, where cells are not
  /// simple, with the assembled one.
  template<typename Number>
  class StiffnessOperator
  {
  public:
    using Vector = LA::VectorOf<Number>;

    /// @param unit of the entries of K, in N/m. The level must outlive the
    ///   object.
    StiffnessOperator(const MeshLevel &level, const Materials &materials,
                      double unit = 1.);

    /// @param matrix K of the mesh itself, in double precision alone. The level
    ///   must outlive the object.
    StiffnessOperator(const MeshLevel &level,
                      std::unique_ptr<const LA::SparseMatrix> matrix);
    ~StiffnessOperator();

    /// The matrix, null if there is none.
    const LA::SparseMatrix *matrix() const { return matrix_.get(); }

    const MeshLevel &level() const { return level_; }

    /// dst = K src, both made by the level's zero_vector(). Collective.
    void vmult(Vector &dst, const Vector &src) const;

    /// The 3 × 3 blocks of the owned nodes on the diagonal, by rows: nine
    /// numbers a node; zero at hanging nodes. Collective.
    std::vector<Number> diagonal_blocks() const;

  private:
    const MeshLevel &level_;
    CellStiffness<Number> cells_;
    std::unique_ptr<const LA::SparseMatrix> matrix_;
  };
} // namespace stiction

#endif
