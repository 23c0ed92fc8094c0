#ifndef stiction_elasticity_multigrid_basis_transformation_h
#define stiction_elasticity_multigrid_basis_transformation_h

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/types.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace stiction
{
  class LevelTransfer;
  class MeshLevel;
  template<typename Number>
  class StiffnessOperator;

  /// Displacements û in which some nodes, the slaves, count from what lies opposite:
  ///
  ///     u = T û:  u_i = û_i + Σ_j N_ij u_j  at the slaves,  u = û  elsewhere,
  ///
  /// with 3 × 3 blocks N_ij (B. Wohlmuth, R. Krause, Monotone multigrid methods on
  /// nonmatching grids for nonlinear multibody contact problems, 2003). What holds a
  /// slave at the other side, then, holds it at a single node, and K̂ = TᵀKT is what a
  /// single body's K would be. A node j may be a slave itself.
  ///
  /// The lists of nodes are known to all ranks.
  class BasisTransformation
  {
  public:
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    /// u = û.
    BasisTransformation() = default;

    /// @param slaves, masters the first unknowns of the nodes i and j.
    /// @param N row 3i + a, column 3j + b. Throws std::invalid_argument if displacements
    ///   would depend on themselves.
    BasisTransformation(std::vector<dealii::types::global_dof_index> slaves,
                        std::vector<dealii::types::global_dof_index> masters, Matrix N);

    /// That of the next coarser level: a slave sees what it sees on the finer one,
    /// interpolated. Collective.
    ///
    /// @param rows which slaves are vertices there. @param slaves their unknowns there.
    BasisTransformation coarser(
      const LevelTransfer &transfer, const MeshLevel &fine, const MeshLevel &coarse,
      const std::vector<Eigen::Index> &rows,
      const std::vector<dealii::types::global_dof_index> &slaves) const;

    bool is_identity() const { return N_.nonZeros() == 0; }

    const std::vector<dealii::types::global_dof_index> &slaves() const { return slaves_; }
    const std::vector<dealii::types::global_dof_index> &masters() const
    {
      return masters_;
    }

    /// N.
    const Matrix &relation() const { return N_; }

    /// T − 1, of the same size.
    const Matrix &added() const { return added_; }

    /// v ← T v, T⁻¹ v. Collective.
    template<typename Number>
    void to_absolute(LA::VectorOf<Number> &v) const;
    template<typename Number>
    void to_relative(LA::VectorOf<Number> &v) const;

    /// Forces on absolute displacements become those on û that do the same work, Tᵀ r,
    /// and back. Collective.
    template<typename Number>
    void forces_to_relative(LA::VectorOf<Number> &r) const;
    template<typename Number>
    void forces_to_absolute(LA::VectorOf<Number> &r) const;

    /// dst = K̂ src. Collective.
    template<typename Number>
    void vmult(const StiffnessOperator<Number> &K, LA::VectorOf<Number> &dst,
               const LA::VectorOf<Number> &src) const;

    /// Adds to the diagonal blocks of K, nine numbers an owned node, what those of the
    /// slaves are in K̂ to the nodes j: Σ_i N_ijᵀ K_ii N_ij, as if slaves were not
    /// coupled with each other. Collective.
    template<typename Number>
    void add_to_diagonal_blocks(const MeshLevel &mesh, std::vector<Number> &blocks) const;

  private:
    using Dofs = std::vector<dealii::types::global_dof_index>;

    /// v_to += factor A v_from, or its transpose.
    template<typename Number, typename Operator>
    static void add(double factor, const Operator &A, const Dofs &to, const Dofs &from,
                    LA::VectorOf<Number> &v);

    Dofs slaves_, masters_;
    Matrix N_, added_;
  };
} // namespace stiction

#endif
