#ifndef stiction_contact_given_friction_h
#define stiction_contact_given_friction_h

#include <stiction/qp/feasible_set.h>

#include <Eigen/Core>

#include <functional>

namespace stiction
{
  /// Contact forces λ (N) with the gradient r = Qλ − h (m) that goes with
  /// them: the remaining gaps and the negative slips. Both of length 3m.
  struct DualIterate
  {
    Eigen::VectorXd lambda;
    Eigen::VectorXd gradient;
  };



  /// When a given-friction solver may stop.
  struct StoppingRule
  {
    /// The natural residual to reach, without a unit.
    double residual = 0.;
    /// The largest last change ‖λ⁽ⁱ⁾ − λ⁽ⁱ⁻¹⁾‖/‖λ⁽ⁱ⁾‖, the paper's rule made
    /// relative; infinity switches it off.
    double change = 0.;
    /// Cap on the iterations.
    unsigned int max_iterations = 0;
  };



  /// What a given-friction solver did.
  struct GivenFrictionResult
  {
    unsigned int iterations = 0;
    double residual         = 0.; ///< natural residual reached
    double change           = 0.; ///< last relative change of λ
    bool converged          = false;
    bool stagnated          = false; ///< rounding stopped the progress
  };



  /// A method for contact with given friction, the paper's problem (D):
  /// min ½ λᵀQλ − λᵀh over λ_ν ≥ 0, ‖λ_t,i‖ ≤ g_i.
  class GivenFrictionSolver
  {
  public:
    /// Called after each iteration with its number, the natural residual and
    /// the relative change.
    using Observer = std::function<
      void(unsigned int iteration, double residual, double change)>;

    virtual ~GivenFrictionSolver() = default;

    /// Improves the iterate until the stopping rule is met.
    ///
    /// @param iterate in: any λ with its gradient; it is made feasible first.
    /// @param slip_bound g ≥ 0, length m, unit: N.
    virtual GivenFrictionResult
    solve(DualIterate &iterate,
          const Eigen::VectorXd &slip_bound,
          const qp::Scaling &scaling,
          const StoppingRule &rule,
          const Observer &observer) = 0;
  };
} // namespace stiction

#endif
