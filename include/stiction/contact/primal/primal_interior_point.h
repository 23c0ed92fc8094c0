#pragma once

#include <stiction/contact/primal/contact_state.h>
#include <stiction/contact/primal/primal_active_set.h>
#include <stiction/qp/solvers/central_path.h>

#include <functional>

namespace stiction
{
  class ContactLevel;
  class NewtonSystem;

  /// An interior point method for contact with given or Coulomb friction in
  /// displacements: the safe way when Newton steps do not get closer.
  ///
  /// Contact forces λ and their duals, gaps and slips, are a point of
  /// qp::CentralPath. To first order the conditions of a node are D Δλ + Δ(gap, slip) =
  /// c, which is a spring D⁻¹ on it: each step is two linear elastic problems on
  /// springs at all contact nodes, a predictor and a corrector, with the solver of
  /// Newton's method. Nothing is sorted into open and closed, so that the stiffness of a
  /// body against bending, however far below that of its nodes, does not matter.
  ///
  /// Equilibrium with λ and the agreement of gaps with the displacement are reached
  /// along with μ → 0 (an infeasible path); a system is solved the better, the smaller
  /// μ is.
  class PrimalInteriorPoint
  {
  public:
    /// Told after each step how many Krylov iterations it took, and where it led.
    using Observer =
      std::function<void(unsigned int iterations, const ContactResidual &)>;

    /// @param system of this problem. It and the problem must outlive the object.
    /// @param start its scales and displacement are taken.
    /// @param tolerance of the residual, at which the path ends.
    /// @param may_be_near whether the path begins near to a start whose residual is
    /// small.
    PrimalInteriorPoint(const ContactLevel &problem, NewtonSystem &system,
                        const ContactState &start, double tolerance, bool may_be_near);

    PrimalInteriorPoint(const PrimalInteriorPoint &)            = delete;
    PrimalInteriorPoint &operator=(const PrimalInteriorPoint &) = delete;

    /// Follows the path from where it is until the residual of the best state is at most
    /// this one, or the end of the path is reached. Collective.
    void solve(double residual, unsigned int max_steps, const Observer &observer);

    /// The state of the path with the smallest residual, the start among them.
    const ContactState &best() const { return best_; }
    double residual() const { return best_residual_; }

    /// Whether the best state is good enough, or further steps gain nothing.
    bool is_at_end() const;

  private:
    // A predictor and a corrector, then as far as the cones allow; false if that is
    // nowhere.
    bool step();

    // Solves the linear system of where the path aims, to an accuracy that fits products
    // of this size; the state becomes that after the whole step. False if it broke down.
    bool find_direction(double mu);

    // The conditions of the nodes, D λ⁺ − w⁺ = c + (gap, slip) + D λ, as springs.
    PrimalActiveSet linearize() const;

    const ContactLevel &problem_;
    NewtonSystem &system_;
    ContactState state_, best_;
    const ContactResidual start_;
    double best_residual_;
    const double tolerance_;
    qp::CentralPath path_;

    // Iterations of the last system, then of the last step, and whether the system was
    // solved as well as it should have been.
    unsigned int krylov_iterations_ = 0;
    bool is_accurate_               = true;

    // Steps in a row in which μ hardly fell, and that gained nothing with systems solved
    // badly.
    unsigned int idle_ = 0, lost_ = 0;
    unsigned int n_steps_ = 0;
    bool is_blocked_      = false; // the boundary of the cones is reached
  };
} // namespace stiction
