#include <stiction/base/phases.h>
#include <stiction/elasticity/linear_algebra/dense_cholesky.h>
#include <stiction/elasticity/linear_algebra/mumps_factorization.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/simulation/reference_costs.h>

#include <deal.II/lac/la_parallel_vector.h>

namespace stiction
{
  ElasticSolveCost measure_elastic_solve(const LinearElasticity &elasticity,
                                         const LA::Vector &contact_force,
                                         const bool matrix_free)
  {
    LA::Vector load = elasticity.constrained_load();
    // loads that nothing but contact balances go with its forces
    if (elasticity.free_motions().n() > 0 || load.linfty_norm() == 0.)
      load += contact_force;
    ElasticSolveCost best;
    for (unsigned int run = 0; run < 2; ++run)
      {
        ElasticSolveCost cost;
        {
          const Phases::Scope with_set_up(cost.seconds);
          const auto solver =
            StiffnessSolver::create(matrix_free ? "multigrid" : "amg", elasticity, 1e-8);
          LA::Vector u = elasticity.zero_vector();
          const Phases::Scope iteration(cost.seconds_of_iteration);
          solver->solve(u, load);
          best.iterations = static_cast<unsigned int>(solver->n_iterations());
        }
        if (run == 0 || cost.seconds < best.seconds)
          best.seconds = cost.seconds;
        if (run == 0 || cost.seconds_of_iteration < best.seconds_of_iteration)
          best.seconds_of_iteration = cost.seconds_of_iteration;
      }
    return best;
  }

  FactorizationCost measure_factorizations(const LinearElasticity &elasticity,
                                           const Eigen::MatrixXd *const Q)
  {
    FactorizationCost cost;
    {
      const Phases::Scope clock(cost.sparse_seconds);
      MumpsFactorization(elasticity.constrained_stiffness());
    }
    if (Q != nullptr)
      {
        Eigen::MatrixXd factor = *Q;
        const Phases::Scope clock(cost.dense_seconds);
        dense_cholesky::factorize(factor.data(), static_cast<int>(factor.rows()));
      }
    return cost;
  }
} // namespace stiction
