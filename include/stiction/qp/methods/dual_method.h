#pragma once

#include <stiction/qp/methods/dual_iterate.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/solver_run.h>

#include <Eigen/Core>

#include <functional>
#include <string>

namespace stiction
{
  /// When a dual method may stop.
  struct StoppingRule
  {
    /// The natural residual to reach, without a unit.
    double residual = 0.;
    /// The largest last change ‖λ⁽ⁱ⁾ − λ⁽ⁱ⁻¹⁾‖/‖λ⁽ⁱ⁾‖, the paper's rule made
    /// relative, for the methods that are stopped by it in the literature.
    double change = 0.;
    /// Cap on the iterations.
    unsigned int max_iterations = 0;
  };

  /// How a run of a dual method ended.
  struct DualMethodResult
  {
    unsigned int iterations = 0;  ///< those that the cap counts
    double residual         = 0.; ///< natural residual reached
    double change           = 0.; ///< last relative change of λ
    bool converged          = false;
    bool stagnated          = false; ///< no further progress was possible
    /// If it stagnated and knows why: that.
    std::string reason;
  };

  /// What a method did so far.
  struct DualMethodStatistics : qp::IterationCounts
  {
    double contraction = 0.; ///< of the last successive approximations

    using IterationCounts::operator+=;

    /// Adds what another method did later.
    DualMethodStatistics &operator+=(const DualMethodStatistics &later)
    {
      IterationCounts::operator+=(later);
      if (later.coulomb_iterations > 0)
        contraction = later.contraction;
      return *this;
    }
  };

  /// A method for the contact problem in its dual form, the paper's (D): with
  /// given friction min ½ λᵀQλ − λᵀh over λ_ν ≥ 0, ‖λ_t,i‖ ≤ g_i; with Coulomb
  /// friction the fixed point g = Fλ_ν of it.
  class DualMethod
  {
  public:
    /// An outermost iteration: how many inner ones it took, the natural
    /// residual after it and the relative change of λ in it.
    struct Step
    {
      unsigned int inner_iterations = 0;
      double residual = 0., change = 0.;
    };
    using Observer = std::function<void(const Step &)>;

    /// What is to be solved, and how far.
    struct Task
    {
      const qp::SlipBound &slip_bound;
      const qp::Scaling &scaling;
      StoppingRule rule;
      Observer observer = [](const Step &) {};

      /// The natural residual of an iterate.
      double residual(const DualIterate &iterate) const
      {
        return qp::natural_residual(iterate.lambda, iterate.gradient, slip_bound,
                                    scaling);
      }
    };

    virtual ~DualMethod() = default;

    /// Improves the iterate until the stopping rule is met. May be called
    /// again, with a stricter rule or other scales.
    ///
    /// @param iterate in: any λ with its gradient; out: a feasible one.
    virtual DualMethodResult solve(DualIterate &iterate, const Task &task) = 0;

    /// Whether solve() takes the slip bound of Coulomb friction. If not, the
    /// method is one for given friction, to be used in successive
    /// approximations.
    virtual bool solves_coulomb() const = 0;

    /// If the method solves another problem than the one given: which, and
    /// what to choose instead; otherwise empty.
    virtual std::string limitation() const { return {}; }

    /// Sums over all runs so far.
    virtual DualMethodStatistics statistics() const { return statistics_; }

  protected:
    DualMethodStatistics statistics_;
  };
} // namespace stiction
