#pragma once

#include <Eigen/Core>

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

namespace stiction
{
  class LinearElasticity;

  /// What one elastic solve costs.
  struct ElasticSolveCost
  {
    double seconds              = 0.; ///< with the set-up
    double seconds_of_iteration = 0.; ///< without it
    unsigned int iterations     = 0;
  };

  /// Solves the body with its contact boundary free by conjugate gradients to
  /// ‖Ku − f‖ ≤ 1e-8 ‖f‖, twice, and takes the better time, because machines
  /// are noisy. Collective.
  ///
  /// @param contact_force the nodal forces of contact on the body, which are f where
  ///   nothing else loads it.
  /// @param matrix_free with geometric multigrid, otherwise algebraic.
  ElasticSolveCost measure_elastic_solve(const LinearElasticity &elasticity,
                                         const LA::Vector &contact_force,
                                         bool matrix_free);

  /// What the factorisations cost that dual methods are built on.
  struct FactorizationCost
  {
    double sparse_seconds = 0.; ///< of K, by MUMPS
    double dense_seconds  = 0.; ///< of Q, Cholesky
  };

  /// Factorises K, which must be assembled, and Q if there is one. Collective.
  FactorizationCost measure_factorizations(const LinearElasticity &elasticity,
                                           const Eigen::MatrixXd *Q);
} // namespace stiction
