#pragma once

#include <stiction/elasticity/linear_algebra/dof_subset.h>

#include <deal.II/base/types.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <map>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace stiction
{
  class LevelTransfer;
  class MeshLevel;
  template<typename Number> class StiffnessOperator;

  /// Thrown where slaves count from each other in a circle, so that û does not say what u
  /// is.
  struct CircleOfSlaves : std::invalid_argument
  {
    using std::invalid_argument::invalid_argument;
  };

  /// Displacements û in which some nodes, the slaves, count from what lies opposite:
  ///
  ///     u = T û:  u_i = û_i + R_i Σ_j N_ij u_j  at the slaves,  u = û  elsewhere,
  ///
  /// with 3 × 3 blocks N_ij and projections R_i, the identity to begin with (B. Wohlmuth,
  /// R. Krause, Monotone multigrid methods on nonmatching grids for nonlinear multibody
  /// contact problems, 2003). What holds a slave at the other side, then, holds it at a
  /// single node, and K̂ = TᵀKT is what the K of a single body would be. A node j may be a
  /// slave itself.
  ///
  /// The lists of nodes are known to all ranks.
  class BasisTransformation
  {
  public:
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    using Dofs   = std::vector<dealii::types::global_dof_index>;
    using Blocks = std::map<Eigen::Index, Eigen::Matrix3d>; ///< by the places of masters

    /// Blocks that preconditioners do without, of the largest of a slave: a pin in a hook
    /// with 170,000 keeps some 27,000, and takes no more iterations (246 for 255).
    static constexpr double small_block = 1e-3;

    /// u = û.
    BasisTransformation();

    /// @param slaves, masters the first unknowns of the nodes i and j.
    /// @param N row 3i + a, column 3j + b. Throws CircleOfSlaves.
    BasisTransformation(Dofs slaves, Dofs masters, const Matrix &N);

    /// That of the next coarser level: a slave sees what it sees on the finer one,
    /// interpolated; without the slaves in it where these would go round in a circle.
    /// Collective.
    ///
    /// @param rows which slaves are vertices there. @param slaves their unknowns there.
    BasisTransformation coarser(const LevelTransfer &transfer, const MeshLevel &fine,
                                const MeshLevel &coarse,
                                const std::vector<Eigen::Index> &rows,
                                const Dofs &slaves) const;

    bool is_identity() const { return relation_->masters.empty(); }

    const Dofs &slaves() const { return relation_->slaves; }
    const Dofs &masters() const { return relation_->masters; }

    /// The blocks N_ij of a slave but for those smaller than this part of the largest,
    /// with the same sum. Where mortar weights hang on each other they decay along all of
    /// the contact.
    Blocks large_blocks_of(std::size_t slave, double part) const;

    /// T − 1, of the size of N.
    Matrix added() const;

    /// The same without small blocks, as above, where a slave has more than 100: enough
    /// for a preconditioner, and K̂ is not full in all of the contact.
    Matrix large_added(double part) const;

    /// Takes R, which makes the displacements of slaves absolute in other directions, and
    /// springs S in these between slaves and what lies opposite, R S = 0.
    void set_relative_directions(std::vector<Eigen::Matrix3d> R,
                                 std::vector<Eigen::Matrix3d> springs);

    const std::vector<Eigen::Matrix3d> &springs() const { return springs_; }

    /// What the springs add to the masters in K̂, Nᵀ S N without small blocks, as if no
    /// slave were a master, and without springs that are less than this part of a
    /// stiffness, of the slaves' unknowns; after set_relative_directions().
    Matrix springs_of_masters(const Eigen::VectorXd &stiffness, double part) const;

    /// Takes springs between the masters and the ground, N/m, which the coarser levels
    /// get as well; without, they are zero. They are no part of K̂: a preconditioner needs
    /// them, where bodies hang on each other and on nothing else.
    void set_ground(Eigen::VectorXd ground) { ground_ = std::move(ground); }

    const Eigen::VectorXd &ground() const { return ground_; }

    /// v ← T v, T⁻¹ v. Collective.
    template<typename Number> void to_absolute(LA::VectorOf<Number> &v) const;
    template<typename Number> void to_relative(LA::VectorOf<Number> &v) const;

    /// Forces on absolute displacements become those on û that do the same work, Tᵀ r,
    /// and back. Collective.
    template<typename Number> void forces_to_relative(LA::VectorOf<Number> &r) const;
    template<typename Number> void forces_to_absolute(LA::VectorOf<Number> &r) const;

    /// dst = K̂ src, with the springs. Collective.
    template<typename Number>
    void vmult(const StiffnessOperator<Number> &K, LA::VectorOf<Number> &dst,
               const LA::VectorOf<Number> &src) const;

    /// What the diagonal blocks K_ii of the slaves add to those of the masters in K̂,
    /// Σ_i N_ijᵀ (R_i K_ii R_i + S_i) N_ij with the springs S_i, as if slaves were not
    /// coupled with each other; after set_relative_directions().
    std::vector<Eigen::Matrix3d> added_blocks(
      const std::vector<Eigen::Matrix3d> &of_slaves) const;

  private:
    struct Relation
    {
      Dofs slaves, masters;
      DofSubset slave_dofs, master_dofs; ///< as the rows and columns of N
      Matrix N;
      Matrix chain;               ///< E: where slaves are masters
      unsigned int n_chained = 0; ///< the k with (N E)^k N = 0, less one
    };

    /// N u, given û at the masters.
    Eigen::VectorXd opposite(const Eigen::VectorXd &of_masters) const;

    /// What forces on slaves and of the springs, on the slaves too, add to those on
    /// masters. @param of_springs empty: none.
    Eigen::VectorXd on_masters(const Eigen::VectorXd &of_slaves,
                               const Eigen::VectorXd &of_springs) const;

    std::shared_ptr<const Relation> relation_;
    Matrix N_; ///< without the rows of slaves that are absolute and have no springs
    std::vector<Eigen::Matrix3d> R_;       ///< empty: the identity
    std::vector<Eigen::Matrix3d> springs_; ///< empty: none
    Eigen::VectorXd ground_;               ///< of the masters
    /// Of vmult(), in either precision, made when they are needed.
    mutable std::tuple<LA::VectorOf<float>, LA::VectorOf<double>> scratch_;
  };
} // namespace stiction
