#pragma once

#include "block_matrix.h"

#include <stiction/elasticity/multigrid/background_multigrid.h>

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>

#include <mpi.h>

#include <memory>
#include <vector>

namespace stiction
{
  /// One grid of the cycle: the operator with springs and its smoother. A scaled
  /// diagonal D of the smoother bounds the eigenvalues of D⁻¹A where functions have
  /// hardly a node in their support; where they have none, D⁻¹ is 0.
  class BackgroundMultigrid::Grid
  {
  public:
    using Springs = std::vector<Eigen::Matrix3f>;

    /// @param A this rank's share of the operator.
    /// @param touched the vertices that may have springs.
    /// @param to_finer the interpolation to the grid before.
    /// @param is_last whether it is solved for directly. Collective.
    Grid(BlockMatrix A, std::vector<unsigned int> touched, const Interpolation &to_finer,
         bool is_last, MPI_Comm communicator);

    const BlockMatrix &share() const { return A_; }
    const std::vector<unsigned int> &touched() const { return touched_; }
    const Interpolation &to_finer() const { return to_finer_; }

    /// At the touched vertices. @param between bodies, a matrix of these vertices, if
    ///   there are any.
    void set_springs(const Springs &springs, std::unique_ptr<BlockMatrix> between);

    /// x becomes a smooth approximation for b, or a better one.
    void smooth_from_zero();
    void smooth();

    /// b − A x. Collective.
    const BlockVector &residual();

    /// x for b, on the last grid.
    void solve();

    BlockVector x, b;

  private:
    void make_diagonal();
    void estimate_largest_eigenvalue();

    /// y = (A + springs) v. Collective.
    void vmult(BlockVector &y, const BlockVector &v) const;

    /// y = D⁻¹ v
    void apply_inverse_diagonal(BlockVector &y, const BlockVector &v) const;

    void smoothing_step(unsigned int k, bool is_first);

    MPI_Comm communicator_;
    BlockMatrix A_;
    std::vector<unsigned int> touched_;
    Interpolation to_finer_;
    Springs springs_, blocks_, inverses_;  ///< at touched vertices; blocks of D
    std::unique_ptr<BlockMatrix> between_; ///< springs between touched vertices
    BlockVector diagonal_, inverse_diagonal_;
    float largest_eigenvalue_ = 0.f;
    BlockVector direction_, product_, scratch_;

    bool is_last_;
    Eigen::MatrixXd dense_; ///< A of the last grid
    Eigen::VectorXd scale_; ///< of its unknowns
    Eigen::LLT<Eigen::MatrixXd> factors_;
  };
} // namespace stiction
