#pragma once

#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/linear_algebra/dof_subset.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <vector>

namespace stiction
{
  class Materials;
  class MeshLevel;

  /// The inverse of K̂ within the unknowns of masters whose slaves are far stiffer. Such
  /// masters move as softly as their own body lets them where the slaves' means stay, and
  /// else as stiffly as the slaves': a diagonal serves the one or the other, and what is
  /// interpolated from a coarser level is not smooth in what the slaves feel. The same on
  /// all ranks.
  class MasterBlock
  {
  public:
    /// Of what slaves add to the diagonal of a master over its own: the block is needed
    /// where it is more.
    static constexpr double much_stiffer = 10.;

    /// @param unit of the stiffness, N/m. @param fixed one at prescribed unknowns.
    ///   Collective.
    MasterBlock(const MeshLevel &mesh, const Materials &materials, double unit,
                const LA::Vector &fixed, const BasisTransformation &basis);

    /// Factorises it for other relative directions and springs of the same relation.
    /// Empty if that fails: where slaves are masters, springs are those without that.
    void set_basis(const BasisTransformation &basis);

    bool is_empty() const { return unknowns_.size() == 0; }

    /// x += K̂_MM⁻¹ r_M. Collective.
    void add_correction(LA::VectorOf<float> &x, const LA::VectorOf<float> &r) const;

  private:
    using Matrix = Eigen::SparseMatrix<double>;

    Matrix K_;                       ///< of slaves and masters, in the absolute basis
    Matrix of_slaves_, of_masters_;  ///< columns: which unknowns of K_ theirs are
    Eigen::VectorXd own_diagonal_;   ///< of K_ at masters
    Eigen::VectorXd felt_stiffness_; ///< of slaves' unknowns, or of masters if softer
    std::vector<bool> is_left_out_;  ///< masters' unknowns: prescribed, or of a slave
    DofSubset unknowns_;             ///< M: those on which slaves weigh more
    Eigen::SimplicialLLT<Matrix> factors_;
  };
} // namespace stiction
