#pragma once

#include <stiction/qp/methods/dual_method.h>

#include <Eigen/Core>

#include <functional>
#include <string>

namespace stiction
{
  class DualOperator;
  class Verifier;

  /// One row of the convergence history.
  struct ContactStep
  {
    unsigned int step       = 0;  ///< number of the outermost iteration
    unsigned int iterations = 0;  ///< inner iterations so far
    double multiplications  = 0.; ///< products with Q so far
    double residual         = 0.; ///< natural residual after the step
    unsigned long unknowns  = 0;  ///< of the level, in displacements
    double change           = 0.; ///< relative change of λ in the step
    double contraction      = 0.; ///< residual over the one before
    double normal_force     = 0.; ///< Σλ_ν in N
    std::string remark;           ///< what else happened in it
  };

  /// How a contact solve ended.
  struct SolveStatus
  {
    bool converged = false;    ///< as the verifier says
    std::string reason;        ///< if not: what stopped the iteration, what to change
    bool interrupted  = false; ///< whether the user stopped it
    bool stands_still = false; ///< whether another method may come closer
    bool slides       = false; ///< whether friction does not hold a body
  };

  /// Solves the contact problem, with the obstacles where they are: lets the
  /// method work, has its result judged, and hands the gradient and the scales
  /// of the judgement back to it until the verifier is content or nothing moves
  /// any more. The method's own stopping test never decides on success.
  /// Collective.
  ///
  /// @param tolerance of the verifier.
  /// @param max_iterations of the method, in all.
  /// @param other_method what to choose where this method comes no closer, a
  ///   part of a sentence.
  /// @param observer called after every step. If it throws Interrupted, on all
  ///   ranks, the iterate of that step is judged and handed back.
  /// @param lambda in: where to start, 3m contact forces in N, or empty: from zero;
  ///   out: the answer.
  SolveStatus certified_solve(DualMethod &method, const DualOperator &Q,
                              const qp::SlipBound &slip_bound, Verifier &verifier,
                              double tolerance, unsigned int max_iterations,
                              const std::string &other_method,
                              const std::function<void(const ContactStep &)> &observer,
                              Eigen::VectorXd &lambda);
} // namespace stiction
