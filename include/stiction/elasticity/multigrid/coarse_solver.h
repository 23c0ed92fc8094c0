#ifndef stiction_elasticity_multigrid_coarse_solver_h
#define stiction_elasticity_multigrid_coarse_solver_h

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/stiffness/nodal_constraint.h>

#include <deal.II/base/types.h>
#include <deal.II/lac/full_matrix.h>

#include <Eigen/Cholesky>

#include <array>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

namespace stiction
{
  class AmgPreconditioner;
  class HostVector;
  class LinearElasticity;
  class MeshLevel;
  class MumpsFactorization;
  class ConstrainedMatrix;

  /// The end of a multigrid cycle: the stiffness matrix of one level of the
  /// mesh with its supports, assembled cell by cell or made from the matrix of
  /// a mesh with hanging nodes or elements of degree 2. A tiny one is factorised by every
  /// rank as a dense matrix, a small one by MUMPS; for a larger one there is a V-cycle of
  /// algebraic multigrid, unless a factorisation is asked for.
  class CoarseSolver
  {
  public:
    /// @param fixed one at unknowns with prescribed displacement, zero
    ///   elsewhere.
    /// @param supported_nodes the first unknowns, on this level, of the nodes
    ///   that supports may hold; the same on all ranks.
    /// @param basis in which the matrix is TᵀKT; must outlive the object.
    /// @param is_direct whether to factorise whatever the size. Collective.
    CoarseSolver(const LinearElasticity &elasticity, const MeshLevel &level,
                 const LA::Vector &fixed,
                 const std::vector<dealii::types::global_dof_index> &supported_nodes,
                 const BasisTransformation &basis, const NodalSupports &supports,
                 bool is_direct);
    ~CoarseSolver();

    /// Whether there is one: not so in another basis where K is assembled first.
    static bool can_be_set_up(const LinearElasticity &elasticity, const MeshLevel &level,
                              const BasisTransformation &basis);

    /// Takes supports for the nodes of the list, the same on all ranks.
    /// Collective.
    void set_supports(const NodalSupports &supports);

    /// Whether vmult() solves exactly.
    bool is_direct() const { return amg_ == nullptr; }

    /// An approximation of dst = K⁻¹ src, symmetric; src and dst are zero in
    /// the directions that are held. Collective.
    void vmult(LA::Vector &dst, const LA::Vector &src) const;

  private:
    void make_pattern();

    /// From which nodes those of a cell take their displacements, by first unknowns: its
    /// own, and those opposite to them. @param T by three rows and columns a node.
    std::vector<dealii::types::global_dof_index> nodes_of(
      const std::vector<dealii::types::global_dof_index> &of_cell,
      Eigen::MatrixXd &T) const;

    /// The directions that supports and prescribed displacements leave free at a node.
    Eigen::Matrix3d projection(dealii::types::global_dof_index first_dof,
                               const NodalSupports &supports) const;

    /// Calls back with matrices to be added at indices, this rank's share.
    using Add = std::function<void(const std::vector<dealii::types::global_dof_index> &,
                                   const dealii::FullMatrix<double> &)>;
    void assemble(const NodalSupports &supports, const Add &add) const;

    /// With what the solver goes on from the matrix.
    void factorize(const LA::SparseMatrix &matrix, const NodalSupports &supports);

    void factorize_dense(const NodalSupports &supports);

    /// The rigid-body modes, without the directions that are held.
    std::vector<std::vector<double>> held_modes(const NodalSupports &supports) const;

    const LinearElasticity &elasticity_;
    const MeshLevel &level_;
    std::unique_ptr<LA::Vector> fixed_;
    std::vector<dealii::types::global_dof_index> supported_nodes_;
    const BasisTransformation &basis_;
    const BasisTransformation::Matrix added_; ///< T − 1
    const bool always_direct_;
    /// Places in lists by first unknowns: of supported nodes, of slaves of the basis.
    std::unordered_map<dealii::types::global_dof_index, std::size_t> support_of_,
      slave_of_;
    /// Which unknowns are prescribed at the nodes opposite, that may be of other ranks.
    std::unordered_map<dealii::types::global_dof_index, std::array<bool, 3>>
      is_fixed_opposite_;
    std::unique_ptr<Eigen::LLT<Eigen::MatrixXd>> dense_;
    std::unique_ptr<LA::SparseMatrix> matrix_;
    std::unique_ptr<LA::SparseMatrix> stiffness_; ///< K, if it is needed as a matrix
    std::unique_ptr<ConstrainedMatrix> assembled_;
    std::unique_ptr<HostVector> host_;
    std::unique_ptr<MumpsFactorization> direct_;
    std::unique_ptr<AmgPreconditioner> amg_;
  };
} // namespace stiction

#endif
