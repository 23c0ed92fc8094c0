#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/stiffness/nodal_constraint.h>

#include <deal.II/base/types.h>

#include <Eigen/Cholesky>

#include <memory>
#include <unordered_map>
#include <vector>

namespace stiction
{
  class AmgPreconditioner;
  class HostVector;
  class Materials;
  class MeshLevel;
  class MumpsFactorization;
  class ConstrainedMatrix;

  /// The end of a multigrid cycle: the stiffness matrix of one level of the mesh with its
  /// supports. A tiny one is factorised by every rank as a dense matrix, a small one by
  /// MUMPS; for a larger one there is a V-cycle of algebraic multigrid, unless a
  /// factorisation is asked for.
  class CoarseSolver
  {
  public:
    /// @param fixed one at unknowns with prescribed displacement, zero
    ///   elsewhere.
    /// @param supported_nodes the first unknowns, on this level, of the nodes
    ///   that supports may hold; the same on all ranks.
    /// @param basis in which the matrix is TᵀKT, without small ones among many weights.
    /// @param is_direct whether to factorise whatever the size. Collective.
    CoarseSolver(const Materials &materials, const MeshLevel &level,
                 const LA::Vector &fixed,
                 const std::vector<dealii::types::global_dof_index> &supported_nodes,
                 const BasisTransformation &basis, const NodalSupports &supports,
                 bool is_direct);
    ~CoarseSolver();

    /// Takes supports for the nodes of the list, the same on all ranks.
    /// Collective.
    void set_supports(const NodalSupports &supports);

    /// Whether vmult() solves exactly, but for weights that the basis left out.
    bool is_direct() const { return amg_ == nullptr; }

    /// An approximation of dst = K⁻¹ src, symmetric; src and dst are zero in
    /// the directions that are held. Collective.
    void vmult(LA::Vector &dst, const LA::Vector &src) const;

  private:
    void factorize_dense(const LA::SparseMatrix &matrix);

    /// The rigid-body modes, without the directions that are held.
    std::vector<std::vector<double>> held_modes(const NodalSupports &supports) const;

    const MeshLevel &level_;
    std::unique_ptr<LA::Vector> fixed_;
    const Eigen::VectorXd ground_; ///< of the masters of the basis
    const bool always_direct_;
    /// Places in the list of all nodes with supports, by first unknowns, and those of the
    /// masters.
    std::unordered_map<dealii::types::global_dof_index, std::size_t> support_of_;
    std::vector<std::size_t> masters_;
    std::size_t n_supported_ = 0;
    std::unique_ptr<LA::SparseMatrix> stiffness_; ///< TᵀKT
    std::unique_ptr<ConstrainedMatrix> constrained_;
    std::unique_ptr<Eigen::LLT<Eigen::MatrixXd>> dense_;
    std::unique_ptr<HostVector> host_;
    std::unique_ptr<MumpsFactorization> direct_;
    std::unique_ptr<AmgPreconditioner> amg_;
  };
} // namespace stiction
