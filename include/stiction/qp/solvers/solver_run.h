#pragma once

#include <array>

namespace stiction::qp
{
  /// What solvers and methods count; the same list for all of them, what does
  /// not apply stays zero.
  struct IterationCounts
  {
    unsigned int coulomb_iterations       = 0; ///< successive approximations
    unsigned int gauss_seidel_iterations  = 0; ///< sweeps
    unsigned int newton_steps             = 0;
    unsigned int krylov_iterations        = 0; ///< in the Newton steps
    unsigned int interior_point_steps     = 0;
    unsigned int conjugate_gradient_steps = 0; ///< of active set methods
    unsigned int expansion_steps          = 0; ///< the active set grew
    unsigned int release_steps            = 0; ///< the active set shrank
    unsigned int admm_iterations          = 0;
    unsigned int dense_factorizations     = 0; ///< Cholesky, order 3m
    unsigned int fallbacks                = 0; ///< to another method

    /// Adds what another solver did that this one called.
    IterationCounts &operator+=(const IterationCounts &other);
  };

  /// One of them, with its name in summary.json and in a sentence.
  struct IterationCount
  {
    unsigned int IterationCounts::*number;
    const char *name, *in_words;
  };

  inline constexpr std::array<IterationCount, 11> iteration_counts = {
    {{&IterationCounts::coulomb_iterations, "coulomb_iterations", "Coulomb steps"},
     {&IterationCounts::gauss_seidel_iterations, "gauss_seidel_iterations",
      "Gauss-Seidel sweeps"},
     {&IterationCounts::newton_steps, "newton_steps", "Newton steps"},
     {&IterationCounts::krylov_iterations, "krylov_iterations", "Krylov iterations"},
     {&IterationCounts::interior_point_steps, "interior_point_steps",
      "interior point steps"},
     {&IterationCounts::conjugate_gradient_steps, "conjugate_gradient_steps", "CG steps"},
     {&IterationCounts::expansion_steps, "expansion_steps", "expansions"},
     {&IterationCounts::release_steps, "release_steps", "releases"},
     {&IterationCounts::admm_iterations, "admm_iterations", "ADMM iterations"},
     {&IterationCounts::dense_factorizations, "dense_factorizations",
      "dense factorizations"},
     {&IterationCounts::fallbacks, "fallbacks", "fallbacks"}}};

  inline IterationCounts &IterationCounts::operator+=(const IterationCounts &other)
  {
    for (const IterationCount &count : iteration_counts)
      this->*count.number += other.*count.number;
    return *this;
  }

  /// How a run of a solver ended, and what it did.
  struct SolverRun : IterationCounts
  {
    unsigned int multiplications = 0;  ///< by active set methods
    double residual              = 0.; ///< natural residual reached
    bool converged               = false;
    bool stagnated               = false; ///< no progress: fall back
  };
} // namespace stiction::qp
