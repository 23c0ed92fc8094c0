#pragma once

#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/levels/master_block.h>
#include <stiction/elasticity/multigrid/multigrid.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace stiction
{
  /// One level of the cycle: the operator with supports and its smoother, in
  /// single precision. All vectors are zero in held directions, except for
  /// arguments where it is said.
  class Multigrid::Level
  {
  public:
    using Vector = LA::VectorOf<float>;

    /// @param unit of the stiffness, N/m: single precision has a small range.
    /// @param fixed one at prescribed unknowns.
    /// @param first_dofs of the nodes that supports may hold.
    /// @param basis whose slaves are these nodes, if it is not the identity. The
    ///   level has its own, in which slaves count from the other side only in directions
    ///   in which they are held, and where they have stiff springs: what moves freely is
    ///   smoothed best by itself.
    Level(const Materials &materials, const MeshLevel &mesh, double unit,
          const LA::Vector &fixed,
          const std::vector<dealii::types::global_dof_index> &first_dofs,
          BasisTransformation basis);

    void set_supports(const NodalSupports &supports);

    /// That of its vectors, which changes with the supports.
    const BasisTransformation &basis() const { return basis_; }

    /// Sets to zero what v has in held directions.
    void project(Vector &v) const;

    /// Improves x as a solution of A x = b, or makes one from nothing.
    void smooth(Vector &x, const Vector &b);
    void smooth_from_zero(Vector &x, const Vector &b);

    /// Improves x at masters of slaves that are far stiffer, if there are any: see
    /// MasterBlock.
    void solve_masters(Vector &x, const Vector &b);

    /// r = b − A x, held directions left out.
    void residual(Vector &r, const Vector &x, const Vector &b) const;

    /// λmax of D⁻¹ K̂, D the diagonal, without supports. Collective.
    float estimate_largest_eigenvalue();

    void set_largest_eigenvalue(const float value) { largest_eigenvalue_ = value; }

    /// A vector for others to use between smoothings.
    Vector &scratch() { return direction_; }

    Vector x, b;

  private:
    /// A node of the list that this rank owns.
    struct Node
    {
      unsigned int local    = 0;  ///< number of the node
      std::size_t in_list   = 0;  ///< place in the list
      Eigen::Index in_basis = -1; ///< place among the masters, -1 if it is none
      /// The diagonal block of K.
      Eigen::Matrix3f block = Eigen::Matrix3f::Zero();
      /// What is added to it in the basis, as to a master.
      Eigen::Matrix3d added = Eigen::Matrix3d::Zero();
      /// The support, P and S.
      Eigen::Matrix3f projection = Eigen::Matrix3f::Identity();
      Eigen::Matrix3f spring     = Eigen::Matrix3f::Zero();
      /// Of P block P + S, within the range of P.
      Eigen::Matrix3f inverse = Eigen::Matrix3f::Zero();
      /// Scratch of a smoothing step.
      Eigen::Vector3f step = Eigen::Vector3f::Zero();
    };

    /// A node opposite to others that this rank owns and that is none of the list.
    struct Master
    {
      unsigned int local        = 0;                       ///< number of the node
      std::size_t in_basis      = 0;                       ///< place among the masters
      Eigen::Vector3f stiffness = Eigen::Vector3f::Zero(); ///< the diagonal of K
      Eigen::Vector3f is_free   = Eigen::Vector3f::Zero(); ///< 1 where not prescribed
    };

    void find_masters(const MeshLevel &mesh, const std::vector<float> &blocks);

    /// Whether slaves are far stiffer than what is opposite. Collective.
    bool has_stiff_slaves(MPI_Comm communicator);

    /// Takes the relative directions of the basis and what that does to diagonals.
    void set_basis(const NodalSupports &supports);

    /// What of x, direction and product counts as zero in a smoothing step.
    enum class Known
    {
      nothing,      ///< x = 0: no product either
      no_direction, ///< the first step from some x
      everything
    };

    /// Step k of the polynomial: direction = keep × direction +
    /// take × D⁻¹ (b − Ax), x += direction, with Kx in product_.
    template<Known known> void smoothing_step(Vector &x, const Vector &b, unsigned int k);

    /// The steps after the first one.
    void smooth_on(Vector &x, const Vector &b);

    const double unit_;
    BasisTransformation basis_;
    std::vector<Eigen::Matrix3d> blocks_of_slaves_; ///< of K, of all ranks
    std::vector<Master> masters_;
    std::unique_ptr<MasterBlock> master_block_; ///< null: no slave is much stiffer
    StiffnessOperator<float> K_;                ///< in the absolute basis
    std::vector<unsigned int> fixed_;           ///< local unknowns
    std::vector<Node> nodes_;
    Vector inverse_diagonal_; ///< zero at fixed unknowns and listed nodes
    Vector product_, direction_;
    float largest_eigenvalue_ = 0.f;
  };
} // namespace stiction
