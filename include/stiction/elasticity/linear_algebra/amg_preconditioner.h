#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <memory>
#include <vector>

namespace stiction
{
  /// A V-cycle of smoothed-aggregation algebraic multigrid (Trilinos ML) that
  /// is told the rigid-body modes.
  class AmgPreconditioner
  {
  public:
    /// Sets up the hierarchy. Collective.
    ///
    /// @param matrix of three rows a node; must outlive the object.
    /// @param modes the rigid-body modes at the owned unknowns, zero where an
    ///   unknown is held.
    AmgPreconditioner(const LA::SparseMatrix &matrix,
                      const std::vector<std::vector<double>> &modes);
    ~AmgPreconditioner();

    /// dst = V-cycle for src. Collective.
    void vmult(LA::Vector &dst, const LA::Vector &src) const;

  private:
    struct Hierarchy;
    std::unique_ptr<Hierarchy> hierarchy_;
  };
} // namespace stiction
