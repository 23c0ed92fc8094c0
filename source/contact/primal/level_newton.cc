#include <stiction/contact/primal/contact_level.h>
#include <stiction/contact/primal/level_newton.h>
#include <stiction/contact/primal/residual_history.h>
#include <stiction/elasticity/multigrid/multigrid.h>
#include <stiction/qp/advice.h>
#include <stiction/qp/contact_scales.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/unbalanced_load.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stiction
{
  namespace
  {
    // A linear system is solved until this part of what the contact conditions
    // lack: from there on, other contact states are worth more.
    constexpr double linear_part = 0.2;

    // The same where Newton steps have stood still with bodies that contact holds:
    // whether one slides is told by pressures that are nearer the truth than its residual
    // is. It is so until the residual has fallen.
    constexpr double fine_linear_part = 0.01;

    // ... and never beyond this part of the tolerance.
    constexpr double linear_part_of_tolerance = 0.3;

    // A force that is released is missing on the other side of a pair, too, where dual
    // weights of both signs share it out.
    constexpr double both_sides = 4.;

    // Where there are no scales yet, the reduction of the first system.
    constexpr double first_reduction = 0.1;

    // What is so much nearer than a cell is large touches. Where no forces are known
    // it is pressed together, by next to nothing, so that the first step holds it: parts
    // that lie on each other move together before anything slides or opens.
    constexpr double touching = 1e-6;

    // A body or an obstacle of which more than this part touches is not brought nearer,
    // one that stands on an edge or a point is.
    constexpr double lies_on = 0.1;

    // ρ is changed if the residual does not fall in so many steps.
    constexpr std::size_t later_fall_horizon = 3;

    // ... at first in so many, while linear systems are easy and the residual is above
    // one: a contact set that starts from nothing grows by a few rows of cells a step,
    // and the residual falls only when it is complete. Without friction hardly anything
    // else can keep it up.
    constexpr std::size_t first_fall_horizon = 8, frictionless_fall_horizon = 20;
    constexpr double no_contact_set = 1.;

    // What the interior point method brings the residual down to, and by, before Newton
    // steps are tried again: near the solution they need fewer and easier systems.
    constexpr double interior_point_part = 0.1;

    // A body that contact alone holds was thrown away if gaps or slips have grown by this
    // since the first state with contact forces.
    constexpr double thrown = 10.;

    // Beyond that, or with parts out of balance, pressures tell nothing of friction.
    constexpr double settled = 1e-2;

    // The factors on the first ρ that are tried in turn: mostly it was too
    // large, cycling, rarely too small.
    constexpr std::array<double, 6> rho_factors = {
      {1., 1. / 3., 10., 1. / 30., 100., 1. / 1000.}};
  } // namespace

  std::size_t LevelNewton::fall_horizon(const unsigned int stalls,
                                        const double residual) const
  {
    if (stalls > 0 || !system_.is_easy() || residual <= no_contact_set)
      return later_fall_horizon;
    const qp::SlipBound &bound = problem_.slip_bound();
    return bound.largest_coefficient() == 0. && bound.constant().isZero(0.)
             ? frictionless_fall_horizon
             : first_fall_horizon;
  }

  LevelNewton::LevelNewton(const ContactLevel &problem, const unsigned int level,
                           Multigrid &preconditioner, const Options &options)
    : problem_(problem)
    , level_(level)
    , preconditioner_(preconditioner)
    , options_(options)
    , system_(problem, level, preconditioner, options.factorizes)
    , c_(options.first_c)
  {
  }

  std::string LevelNewton::solve(ContactState &state, Eigen::VectorXd first_lambda,
                                 const double tolerance, const unsigned int max_steps,
                                 const Observer &observer)
  {
    std::string reason =
      iterate(state, std::move(first_lambda), tolerance, max_steps, observer);
    if (!reason.empty() && path_)
      {
        const ContactResidual residual(problem_, state, problem_.slip_bound());
        if (path_->residual() < residual.value() && !slides(residual))
          state = path_->best();
      }
    return reason;
  }

  std::string LevelNewton::iterate(ContactState &state, Eigen::VectorXd lambda,
                                   const double tolerance, const unsigned int max_steps,
                                   const Observer &observer)
  {
    ContactResidual residual(problem_, state, problem_.slip_bound());
    keep_first(state);
    ResidualHistory history;
    Pace pace;
    unsigned int stalls = 0, stalls_without_path = 0;
    const auto from_elsewhere = [&]() {
      return solve_from_elsewhere(state, tolerance, max_steps, observer);
    };

    // Never less than a step: without contact forces there may be no scales,
    // and then anything is small.
    for (bool has_stepped = false;; has_stepped = true)
      {
        if (has_stepped && residual.value() <= tolerance)
          {
            drop_rounding(state, residual);
            return {};
          }
        if (statistics_.n_steps() >= max_steps)
          return "the cap on Newton steps was met, " +
                 pace.advice(tolerance, options_.other_method);
        if (!options_.only_fallback)
          {
            step(state, lambda, residual, tolerance);
            residual = measure(state, tolerance);
            lambda   = state.lambda;
            observer(statistics_, residual);
            if (touches_only(state) && drop_rounding(state, residual))
              return {};
            history.add(residual.value());
            pace.add(statistics_.n_steps(), residual.value());
          }
        stands_still_ = !std::isfinite(residual.value());
        if (stands_still_)
          return from_elsewhere().value_or(
            "the iteration broke down: the displacement is no number");
        if (system_.is_too_hard() && residual.value() > tolerance)
          {
            stands_still_ = true;
            return from_elsewhere().value_or(why_no_closer());
          }
        keep_first(state);
        if (!options_.only_fallback &&
            (residual.value() <= tolerance ||
             history.falls(fall_horizon(stalls, residual.value()))))
          continue;

        if (drop_rounding(state, residual))
          return {};
        if (is_rounding(residual.value(),
                        problem_.rounding_of_forces(state.u) / residual.force_scale))
          {
            // a step may have thrown a body far away that contact alone holds
            const std::string advice = advice_on_rounding(residual.value());
            stands_still_            = problem_.driven_motions().cols() > 0;
            return stands_still_ ? from_elsewhere().value_or(advice) : advice;
          }

        // change ρ, and every second time fall back as well, or go on with that where
        // Newton steps do not finish what it began
        history.clear();
        ++stalls;
        c_ = options_.first_c * rho_factors[stalls % rho_factors.size()];
        ++statistics_.rho_changes;
        if (problem_.driven_motions().cols() > 0)
          fine_above_ = ResidualHistory::required_fall * residual.value();
        if (!path_ && ++stalls_without_path % 2 == 1 && !options_.only_fallback)
          continue;
        if (slides(residual))
          return "friction does not hold the body at these pressures, change the loads";
        if (const auto reason = from_elsewhere())
          return *reason;
        stands_still_ = !path_ && (statistics_.fallbacks == options_.max_fallbacks ||
                                   has_hard_systems());
        if (stands_still_)
          return why_no_closer();
        fall_back(state, residual.value(), tolerance, max_steps - statistics_.n_steps(),
                  observer);
        residual = measure(state, tolerance);
        lambda   = state.lambda;
        history.add(residual.value());
      }
  }

  std::optional<std::string> LevelNewton::solve_from_elsewhere(
    ContactState &state, const double tolerance, const unsigned int max_steps,
    const Observer &observer)
  {
    const Statistics before = statistics_;
    if (!options_.other_start || before.n_steps() >= max_steps)
      return std::nullopt;
    Eigen::VectorXd start = std::exchange(options_.other_start, {})();
    if (start.size() == 0)
      return std::nullopt;
    LevelNewton newton(problem_, level_, preconditioner_, options_);
    const std::string reason =
      newton.solve(state, std::move(start), tolerance, max_steps - before.n_steps(),
                   [&](Statistics now, const ContactResidual &residual) {
                     if (now.factorized_from > 0)
                       now.factorized_from += before.n_steps();
                     statistics_ = before;
                     statistics_ += now;
                     observer(statistics_, residual);
                   });
    stands_still_ = newton.stands_still_;
    return reason;
  }

  void LevelNewton::keep_first(const ContactState &state)
  {
    if (!first_ && problem_.driven_motions().cols() > 0 && !state.lambda.isZero(0.))
      first_ = std::make_unique<ContactState>(state);
  }

  ContactResidual LevelNewton::measure(ContactState &state, const double tolerance) const
  {
    ContactResidual residual(problem_, state, problem_.slip_bound());
    if (residual.value() > tolerance)
      return residual;
    state.update(problem_);
    residual = {problem_, state, problem_.slip_bound()};
    if (residual.value() <= tolerance)
      return residual;
    ContactState without = state;
    const double released =
      both_sides * without.release_open_nodes(problem_, residual.conditions.scaling()) /
      residual.force_scale;
    if (residual.equilibrium + released > tolerance)
      return residual;
    state = without;
    return {problem_, state, problem_.slip_bound()};
  }

  bool LevelNewton::drop_rounding(ContactState &state,
                                  const ContactResidual &residual) const
  {
    if (problem_.slip_bound().has_given() || !problem_.motion().forces().isZero(0.) ||
        residual.force_scale >= only_rounding * problem_.rounding_of_forces(state.u))
      return false;
    // the sums may be those of a stiff body that moves far, beside a soft one
    ContactState without = state;
    without.update(problem_);
    if (!problem_.is_rounding(without.R, without.u))
      return false;
    state = without;
    state.lambda.setZero();
    return true;
  }

  bool LevelNewton::touches_only(const ContactState &state) const
  {
    return (state.w.head(problem_.n_nodes()).array() <=
            rounding_of_gaps * state.u.linfty_norm())
      .all();
  }

  bool LevelNewton::slides(const ContactResidual &residual) const
  {
    const ContactConditions &conditions = residual.conditions;
    const double error = std::max(conditions.normal_residual(), residual.equilibrium);
    return problem_.driven_motions().cols() > 0 && error <= settled &&
           problem_.unbalanced_part(qp::SlipBound::given(conditions.slip_bound())) >
             qp::safe_beside_pressures * error;
  }

  bool LevelNewton::has_hard_systems() const
  {
    return system_.n_unfinished() > 0 && !preconditioner_.is_direct(level_) &&
           2 * system_.n_unfinished() >=
             statistics_.newton_steps + 2 * statistics_.interior_point_steps;
  }

  std::string LevelNewton::why_no_closer() const
  {
    if (!has_hard_systems())
      return "neither Newton steps nor the interior point method come closer, " +
             options_.other_method + advice_on_friction(problem_.slip_bound());
    return "most linear systems were not solved in " +
           std::to_string(system_.max_directions()) + " iterations each (" +
           options_.hard_systems +
           "), and are too large to be factorised in every step, " +
           options_.other_method;
  }

  void LevelNewton::step(ContactState &state, Eigen::VectorXd lambda,
                         const ContactResidual &residual, const double tolerance)
  {
    const Eigen::VectorXd rho = c_ * problem_.nodal_stiffness();
    const bool is_first       = lambda.isZero(0.);
    if (is_first)
      lambda.head(rho.size()) = touching * rho.cwiseProduct(problem_.areas().cwiseSqrt());
    problem_.bring_into_contact(
      state, lambda.head(rho.size()) + rho.cwiseProduct(state.w.head(rho.size())),
      is_first ? lies_on : 0.);
    PrimalActiveSet linearization(lambda, state.w, rho, problem_.slip_bound());
    linearization.tether(problem_.driven_motions(), problem_.foundation(), state.w);
    const double part = residual.value() > fine_above_ ? fine_linear_part : linear_part;
    const double force_scale  = residual.force_scale;
    const qp::Scaling scaling = residual.conditions.scaling();
    const bool has_scales     = residual.conditions.lambda().squaredNorm() > 0.;

    const auto is_enough = [&](const NewtonSystem::Progress &now) {
      if (!has_scales)
        return now.reduction <= first_reduction;
      const double linear =
        std::max({now.residual / force_scale,
                  largest_at_nodes(now.contact_residual, scaling.force),
                  problem_.motion().force_error(now.lambda)});
      return linear <=
             std::max(linear_part_of_tolerance * tolerance,
                      part * qp::natural_residual(now.lambda, -now.w,
                                                  problem_.slip_bound(), scaling));
    };
    const unsigned int iterations =
      system_.solve(state, linearization, is_enough,
                    residual.value() <= (was_unfinished_ ? no_contact_set : settled));
    was_unfinished_ = system_.left_unfinished();
    statistics_.krylov_iterations += iterations;
    ++statistics_.newton_steps;
    note_factorization();
  }

  void LevelNewton::note_factorization()
  {
    if (system_.is_factorized() && statistics_.factorized_from == 0)
      statistics_.factorized_from = statistics_.n_steps() + 1;
  }

  void LevelNewton::fall_back(ContactState &state, const double residual,
                              const double tolerance, const unsigned int max_steps,
                              const Observer &observer)
  {
    if (!path_)
      {
        const bool is_thrown = first_ && state.w.lpNorm<Eigen::Infinity>() >
                                           thrown * first_->w.lpNorm<Eigen::Infinity>();
        path_ = std::make_unique<PrimalInteriorPoint>(
          problem_, system_, is_thrown ? *first_ : state, 0.5 * tolerance,
          statistics_.fallbacks + 1 < options_.max_fallbacks);
        first_.reset(); // a second path from there would be the same
        ++statistics_.fallbacks;
      }
    const double target =
      options_.only_fallback
        ? 0.
        : interior_point_part * std::min({1., residual, path_->residual()});
    was_unfinished_            = false;
    const auto take_the_better = [&]() {
      if (path_->residual() < residual)
        state = path_->best();
    };
    take_the_better();
    path_->solve(target, max_steps,
                 [&](const unsigned int iterations, const ContactResidual &now) {
                   ++statistics_.interior_point_steps;
                   statistics_.krylov_iterations += iterations;
                   note_factorization();
                   take_the_better(); // an interrupt leaves from the observer
                   observer(statistics_, now);
                 });
    if (path_->is_at_end())
      path_.reset();
  }
} // namespace stiction
