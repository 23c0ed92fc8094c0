#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <Eigen/Core>

#include <memory>
#include <string>

namespace stiction
{
  class LinearElasticity;
  class DofSubset;

  /// K⁻¹ for the stiffness matrix with prescribed displacements eliminated.
  /// Counts what it does.
  class StiffnessSolver
  {
  public:
    virtual ~StiffnessSolver() = default;

    /// A solver by its name in the parameter file: mumps, amg, multigrid.
    ///
    /// @param relative_residual what an iterative solver has to reach,
    ///   ‖b − Kx‖ ≤ relative_residual ‖b‖; a factorisation goes as far as
    ///   rounding lets it.
    static std::unique_ptr<StiffnessSolver> create(const std::string &type,
                                                   const LinearElasticity &elasticity,
                                                   double relative_residual);

    /// dst = K⁻¹ src. Collective. Throws std::runtime_error if an iteration
    /// breaks down.
    void solve(LA::Vector &dst, const LA::Vector &src);

    /// The compliance of a list of unknowns: the block of K⁻¹ in their rows
    /// and columns, the same on every rank. Unit: m/N. Collective.
    ///
    /// Made by one solve a column unless the solver knows better.
    virtual Eigen::MatrixXd compliance(const DofSubset &subset);

    /// Number of right-hand sides solved for.
    unsigned long n_solves() const { return n_solves_; }

    /// Sum of the iterations of all solves; 0 for a factorisation.
    unsigned long n_iterations() const { return n_iterations_; }

  protected:
    explicit StiffnessSolver(const LinearElasticity &elasticity);

    /// Does the work of solve(); returns the number of iterations.
    virtual unsigned int do_solve(LA::Vector &dst, const LA::Vector &src) = 0;

    const LinearElasticity &elasticity_;

  private:
    unsigned long n_solves_ = 0, n_iterations_ = 0;
  };
} // namespace stiction
