#pragma once

#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/multigrid/multigrid.h>

#include <memory>
#include <vector>

namespace stiction
{
  /// An approximate inverse of the stiffness matrix of nearly incompressible bodies,
  /// which smoothing node by node cannot do. Where the volume strain is the mean of each
  /// cell, K is A + BᵀC⁻¹B: A of a softer bulk modulus, C⁻¹ the rest of it, BᵀB of rank
  /// one in each cell, and
  ///
  ///     A u + Bᵀ p = b,   B u − C p = 0
  ///
  /// is solved for displacements and pressures of the cells by generalised conjugate
  /// residuals. Their preconditioner is block triangular: a V-cycle for A, and for the
  /// pressures the diagonal matrix C + D, D⁻¹ being (2μ + λ)/volume of A (H. Elman, D.
  /// Silvester, A. Wathen, Finite Elements and Fast Iterative Solvers, 2014, chapter 4).
  ///
  /// That depends on b in a nonlinear way, if by little.
  class MixedPreconditioner
  {
  public:
    /// Whether there is a nearly incompressible material with such means.
    static bool serves(const LinearElasticity &elasticity);

    /// The arguments of Multigrid. @param fixed of each level, one at prescribed
    /// unknowns.
    MixedPreconditioner(const LinearElasticity &elasticity,
                        const MeshHierarchy &hierarchy,
                        const DofSubsetHierarchy &supported_nodes,
                        const std::vector<BasisTransformation> &bases,
                        const std::vector<LA::Vector> &fixed, bool is_geometric);
    ~MixedPreconditioner();

    /// Takes new supports on a level and carries them to the coarser ones. Collective.
    void set_supports(unsigned int level, const NodalSupports &supports);

    /// Forgets supports, as if made anew.
    void forget() { cycle_.forget(); }

    /// dst is so near to the inverse times src that a tenth of the residual is left, if
    /// max_iterations are enough for that. What src has in held directions is ignored.
    /// Collective.
    ///
    /// @return whether they were.
    bool vmult(unsigned int level, LA::Vector &dst, const LA::Vector &src);

    static constexpr unsigned int max_iterations = 60;

  private:
    class System;

    Materials softened_; ///< of A
    Materials simple_;   ///< of its V-cycle, which is quick without means
    Multigrid cycle_;
    std::vector<std::unique_ptr<System>> systems_; ///< of the levels
  };
} // namespace stiction
