#include <stiction/base/interrupted.h>
#include <stiction/qp/advice.h>
#include <stiction/qp/certified_solve.h>
#include <stiction/qp/contact_scales.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/verifier.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    // The scales of zero contact forces are those of a body that falls through
    // its foundation; they are taken afresh once the residual is this small.
    constexpr double coarse_residual = 1e-2;

    // What the method's residual has to reach, as a part of the tolerance: the
    // verifier measures in scales of the next iterate.
    constexpr double safety = 0.5;

    // The relative overlap up to which no contact forces at all are the answer.
    constexpr double rest_tolerance = 1e-9;

    // Judgements without a new smallest residual before giving up.
    constexpr unsigned int max_idle_judgements = 3;

    // Other figures decide too: a complementarity of more than the KKT residual
    // (where the pressure is above p0) asks for a smaller one.
    double share_of_kkt(const ContactConditions &conditions)
    {
      const auto &figures  = conditions.contact_figures();
      const double largest = std::max({figures.kkt_residual, figures.penetration,
                                       figures.complementarity, figures.cone_violation});
      return largest > 0. ? std::max(figures.kkt_residual / largest, 0.01) : 1.;
    }

    // The verifier's scales, unless they are rounding or a convention: a body that
    // is only moved has neither load nor strain as long as there are no contact
    // forces. Then those of the forces count that would undo h node by node,
    // and always where no contact forces at all are to be the answer. Of h so small that
    // its square is nothing there is no work to take a scale from.
    qp::Scaling usable_scaling(const ContactConditions &conditions, const DualOperator &Q,
                               const qp::SlipBound &slip_bound, const double tolerance)
    {
      constexpr double rounding = 1e-6;

      qp::Scaling scaling      = conditions.scaling();
      const auto [force, work] = decoupled_scales(Q, slip_bound);
      const double total       = scaling.force.sum();
      const bool is_answer =
        conditions.lambda().isZero(0.) && conditions.is_solved(tolerance);
      if (work > 0. && (is_answer || total < rounding * force))
        {
          scaling.force *= force / total;
          scaling.displacement = work / force;
        }
      return scaling;
    }

    // Makes the row of the step before that of this one.
    void add(const DualMethod::Step &step, const Eigen::VectorXd &lambda,
             const DualOperator &Q, ContactStep &row)
    {
      row.contraction = row.residual > 0. ? step.residual / row.residual : 0.;
      ++row.step;
      row.iterations += step.inner_iterations;
      row.multiplications = Q.n_multiplications();
      row.residual        = step.residual;
      row.change          = step.change;
      row.normal_force    = lambda.head(Q.n_nodes()).sum();
    }

    // No contact forces at all leave nothing to measure an overlap by: they are
    // the answer if there is none, whatever the tolerance.
    double accuracy(const Eigen::VectorXd &lambda, const double tolerance)
    {
      return lambda.isZero(0.) ? std::min(tolerance, rest_tolerance) : tolerance;
    }

    // Of a method that comes no closer. @param advice what may.
    std::string why_no_closer(const DualMethodResult &result,
                              const ContactConditions &conditions,
                              const std::string &advice)
    {
      if (const double residual = conditions.contact_figures().kkt_residual;
          is_rounding(residual, conditions.rounding()))
        return advice_on_rounding(residual);
      return (result.reason.empty() ? "the method makes no further progress"
                                    : result.reason) +
             ", " + advice;
    }
  } // namespace

  SolveStatus certified_solve(DualMethod &method, const DualOperator &Q,
                              const qp::SlipBound &slip_bound, Verifier &verifier,
                              const double tolerance, const unsigned int max_iterations,
                              const std::string &other_method,
                              const std::function<void(const ContactStep &)> &observer,
                              Eigen::VectorXd &lambda)
  {
    const std::string advice = other_method + advice_on_friction(slip_bound);
    SolveStatus status;
    const bool is_cold = lambda.size() == 0;
    if (is_cold)
      lambda = Eigen::VectorXd::Zero(3 * Q.n_nodes());
    const ContactConditions *conditions = &verifier.verify(lambda);
    DualIterate iterate{lambda, conditions->gradient()};

    ContactStep row;
    Pace pace;
    row.residual = conditions->contact_figures().kkt_residual;

    double target =
      std::max(is_cold ? coarse_residual : std::min(coarse_residual, 0.3 * row.residual),
               0.5 * tolerance);
    double smallest         = row.residual;
    unsigned int iterations = 0, idle = 0;
    qp::Scaling scaling = usable_scaling(*conditions, Q, slip_bound, tolerance);

    // in both scales: they must be right in those of the problem, too
    const auto is_content = [&]() {
      return conditions->is_solved(tolerance) &&
             ContactConditions(lambda, conditions->gradient(), slip_bound.at(lambda),
                               scaling)
               .converged(accuracy(lambda, tolerance));
    };
    while (!is_content())
      {
        if (!iterate.gradient.allFinite() || !Q.nodal_compliance().allFinite())
          return {false,
                  "the displacements that loads and forces cause are no numbers, which a "
                  "fault in an elastic solve leads to, " +
                    advice};
        const StoppingRule rule{target, std::max(tolerance, target),
                                max_iterations - iterations};
        const auto after_step = [&](const DualMethod::Step &step) {
          add(step, iterate.lambda, Q, row);
          pace.add(row.iterations, row.residual);
          observer(row);
        };
        DualMethodResult result;
        try
          {
            result = method.solve(iterate, {slip_bound, scaling, rule, after_step});
          }
        catch (const Interrupted &)
          {
            status.interrupted = true;
          }
        iterations += result.iterations;
        lambda           = iterate.lambda;
        conditions       = &verifier.verify(lambda);
        iterate.gradient = conditions->gradient();
        scaling          = usable_scaling(*conditions, Q, slip_bound, tolerance);
        if (is_content())
          break;
        if (status.interrupted)
          return status;

        const double residual = conditions->contact_figures().kkt_residual;
        idle                  = residual < 0.9 * smallest ? 0 : idle + 1;
        smallest              = std::min(smallest, residual);
        const double goal =
          safety * accuracy(lambda, tolerance) * share_of_kkt(*conditions);
        if (result.converged && target <= goal && !method.limitation().empty())
          status.reason = method.limitation();
        else if (iterations >= max_iterations)
          status.reason = "the cap of " + std::to_string(max_iterations) +
                          " iterations was met, " + pace.advice(tolerance, advice);
        else if (result.stagnated || idle >= max_idle_judgements ||
                 !std::isfinite(residual))
          status.reason = why_no_closer(result, *conditions, advice);
        if (!status.reason.empty())
          return status;

        target = target > goal ? goal : 0.3 * target;
      }
    status.converged = true;
    return status;
  }
} // namespace stiction
