#include <stiction/contact/contact_surface.h>
#include <stiction/contact/newton_multigrid.h>
#include <stiction/elasticity/linear_elasticity.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <limits>

namespace stiction
{
  namespace
  {
    double env(const char*n,double d){const char*e=getenv(n);return e?atof(e):d;}

    std::vector<dealii::types::global_dof_index>
    first_dofs(const ContactSurface &surface)
    {
      const auto &dofs = surface.trace().dofs();
      return {dofs.begin(), dofs.begin() + surface.n_nodes()};
    }
  } // namespace



  NewtonMultigrid::NewtonMultigrid(const LinearElasticity &elasticity,
                                   const ContactSurface &surface,
                                   const bool levels_in_use,
                                   const Options &options)
    : options_(options)
    , hierarchy_(elasticity.body(), elasticity.mesh(), levels_in_use)
    , trace_hierarchy_(hierarchy_, first_dofs(surface))
    , multigrid_(elasticity, hierarchy_, trace_hierarchy_)
    , problems_(hierarchy_.n_levels())
    , statistics_(hierarchy_.n_levels())
  {
    problems_.back() = std::make_unique<ContactLevel>(elasticity, surface);
    for (unsigned int l = finest_level(); l > 0; --l)
      problems_[l - 1] = std::make_unique<ContactLevel>(
        *problems_[l], elasticity, hierarchy_, trace_hierarchy_, l - 1);
    for (unsigned int l = 0; l < hierarchy_.n_levels(); ++l)
      statistics_[l].dofs = hierarchy_.level(l).n_dofs();
  }



  ContactSolution
  NewtonMultigrid::solve(const double tolerance,
                         const unsigned int max_steps,
                         const Observer &observer)
  {
    // a coarse level need not be solved better than it is an approximation
    const double coarse_tolerance = env("CT",1e-3);

    row_   = ContactStep();
    state_ = std::make_unique<ContactState>(*problems_[0]);
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(state_->lambda.size());
    LevelResult result;
    for (unsigned int l = 0; l < hierarchy_.n_levels(); ++l)
      {
        if (l > 0)
          prolongate(l, lambda);
        result = solve_level(l,
                             l == finest_level()
                               ? tolerance
                               : std::max(coarse_tolerance, tolerance),
                             max_steps,
                             lambda,
                             observer);
        lambda = state_->lambda;
      }
    ContactSolution solution;
    solution.lambda    = state_->lambda;
    solution.converged = result.converged;
    solution.reason    = result.reason;
    return solution;
  }



  void
  NewtonMultigrid::prolongate(const unsigned int level, Eigen::VectorXd &lambda)
  {
    const ContactLevel &coarse = *problems_[level - 1];
    const ContactLevel &fine   = *problems_[level];
    auto state                 = std::make_unique<ContactState>(fine);
    hierarchy_.transfer(level).prolongate(state->u, state_->u);
    fine.prescribe(state->u);
    state->update(fine);
    state_ = std::move(state);

    // pressures are interpolated, forces belong to areas
    const auto &weights  = trace_hierarchy_.prolongation(level);
    const Eigen::Index m = coarse.n_nodes(), n = fine.n_nodes();
    Eigen::VectorXd fine_lambda(3 * n);
    for (unsigned int c = 0; c < 3; ++c)
      fine_lambda.segment(c * n, n) = fine.areas().cwiseProduct(
        weights * lambda.segment(c * m, m).cwiseQuotient(coarse.areas()));
    lambda = fine_lambda;
  }



  NewtonMultigrid::LevelResult
  NewtonMultigrid::solve_level(const unsigned int level,
                               const double tolerance,
                               const unsigned int max_steps,
                               const Eigen::VectorXd &first_lambda,
                               const Observer &observer)
  {
    const ContactLevel &problem = *problems_[level];
    ContactState &state         = *state_;
    LevelStatistics &statistics = statistics_[level];
    SupportedSystem system(problem, level, multigrid_);

    double c = options_.first_c;
    Eigen::VectorXd lambda = first_lambda;
    auto residual = std::make_unique<ContactResidual>(problem, state);
    if (getenv("DBG")) printf("level %u dofs %lu m %ld start residual %.3e eq %.3e\n", level, statistics.dofs, (long)problem.n_nodes(), residual->value(), residual->equilibrium);
    std::deque<double> history;
    LevelResult result;
    while (residual->value() > tolerance && statistics.newton_steps < max_steps)
      {
        const PrimalLinearization linearization(lambda,
                                                state.w,
                                                c * problem.nodal_stiffness(),
                                                problem.slip_bound());
        const double S            = residual->force_scale;
        const qp::Scaling scaling = residual->conditions.scaling();
        const bool has_scales = state.lambda.size()==0 || residual->conditions.lambda().squaredNorm() > 0.;
        double l0=-1;
        const unsigned int iterations = system.solve(
          state, linearization, [&](const SupportedSystem::Progress &now) {
            double linear = problem.sum_of_norms(now.residual) / S;
            const Eigen::Index m = problem.n_nodes();
            double contact_linear = 0;
            for (Eigen::Index i = 0; i < m; ++i)
              contact_linear = std::max(contact_linear,
                                std::sqrt(std::pow(now.contact_residual(i), 2) +
                                          std::pow(now.contact_residual(i + m), 2) +
                                          std::pow(now.contact_residual(i + 2 * m), 2)) /
                                  scaling.force(i));
            linear=std::max(linear,contact_linear);
            const ContactConditions conditions(
              now.lambda, -now.w, problem.slip_bound().at(now.lambda), scaling);
            const double nonlinear = conditions.contact_figures().kkt_residual;
            if (getenv("DBG2")) printf("     it %u linear %.3e (contact %.3e) nonlinear %.3e red %.3e\n", now.iterations, linear, contact_linear, nonlinear, now.reduction);
            (void)l0;
            if (!has_scales) return now.reduction <= 0.1;
            return linear <= env("TT",0.3) * tolerance || linear <= env("ETA",0.2) * nonlinear;
          });
        lambda = state.lambda;
        ++statistics.newton_steps;
        statistics.krylov_iterations += iterations;
        residual = std::make_unique<ContactResidual>(problem, state);
        if (getenv("DBG")) { auto f=residual->conditions.contact_figures(); printf("  step %u its %u residual %.3e kkt %.3e pen %.3e compl %.3e cone %.3e eq %.3e c %.3g\n", statistics.newton_steps, iterations, residual->value(), f.kkt_residual,f.penetration,f.complementarity,f.cone_violation, residual->equilibrium, c); }
        ++row_.step;
        row_.iterations += iterations;
        row_.contraction  = residual->value() / row_.residual;
        row_.residual     = residual->value();
        row_.normal_force = state.lambda.head(problem.n_nodes()).sum();
        observer(row_);

        history.push_back(residual->value());
        if (history.size() > 3 &&
            history.back() > 0.7 * history[history.size() - 4])
          {
            c /= 3.;
            ++statistics.reductions;
            history.clear();
          }
      }
    result.converged = residual->value() <= tolerance;
    return result;
  }
} // namespace stiction
