#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/types.h>

#include <Eigen/Core>

#include <mpi.h>

#include <memory>
#include <vector>

namespace stiction
{
  /// A sparse Cholesky factorisation of a distributed symmetric positive
  /// definite matrix by MUMPS, with or without the Schur complement on a list
  /// of unknowns.
  ///
  /// deal.II's and Trilinos' interfaces to MUMPS reach neither the Schur
  /// complement nor its condensed solves, so this talks to MUMPS' C interface.
  ///
  /// With a list C of unknowns only the others, I, are eliminated. Then a
  /// system K x = b is solved in three steps: condense() gives
  /// b_C − K_CI K_II⁻¹ b_I, the caller solves with
  /// S = K_CC − K_CI K_II⁻¹ K_IC, and expand() completes x. Right-hand sides,
  /// solutions and S live on rank 0.
  class MumpsFactorization
  {
  public:
    /// Analyses and factorises. Collective.
    ///
    /// @param matrix with unknowns numbered node by node in threes: the fill-reducing
    ///   ordering works on nodes.
    /// @param schur_dofs the list C, the same on all ranks; may be empty.
    ///
    /// Throws std::runtime_error with MUMPS' error numbers on all ranks, and
    /// std::bad_alloc if the memory does not suffice.
    explicit MumpsFactorization(
      const LA::SparseMatrix &matrix,
      const std::vector<dealii::types::global_dof_index> &schur_dofs = {});
    ~MumpsFactorization();

    /// Factorises another matrix with the same sparsity pattern, which may have its zeros
    /// elsewhere. The first such matrix is analysed, later ones are not. Collective.
    void refactorize(const LA::SparseMatrix &matrix);

    /// S, of which only the lower triangle is set; on rank 0, empty elsewhere.
    /// The caller may overwrite it.
    Eigen::MatrixXd &schur_complement();

    /// Whether this is rank 0.
    bool is_host() const;

    /// Without a list C: replaces b by K⁻¹ b. b counts on rank 0. Collective.
    void solve(Eigen::VectorXd &b);

    /// Step one of a solve with a list C: b is the right-hand side on rank 0,
    /// condensed is set there. Collective.
    void condense(Eigen::VectorXd &b, Eigen::VectorXd &condensed);

    /// Step three, after condense() of the same b: condensed is S⁻¹ of what
    /// condense() gave, b becomes x. Collective.
    void expand(Eigen::VectorXd &b, Eigen::VectorXd &condensed);

  private:
    struct Mumps;
    std::unique_ptr<Mumps> mumps_;
  };
} // namespace stiction
