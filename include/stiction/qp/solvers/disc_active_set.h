#pragma once

#include <stiction/qp/solvers/active_set_method.h>

namespace stiction::qp
{
  class Discs;

  /// The paper's unbalanced boundary residual v_i = −r_i − (‖r_i‖/g_i) x_i at
  /// every node on its circle, zero elsewhere and where g_i = 0.
  ///
  /// It points into the disc, is a descent direction unless it is zero, and
  /// is zero exactly when the KKT boundary condition g r = −‖r‖ x holds.
  Eigen::VectorXd unbalanced_boundary_residual(const Discs &discs,
                                               const Eigen::VectorXd &x,
                                               const Eigen::VectorXd &gradient);

  /// How far the unbalanced boundary residual leads before a disc is left:
  /// min g_i/‖r_i‖ over the nodes with v_i ≠ 0, infinity if there is none.
  ///
  /// From ‖x_i + α v_i‖ = g_i one gets exactly α = g_i/‖r_i‖. The quadratic
  /// formula for the same number cancels when v_i is small, and the iteration
  /// would stall there for thousands of steps.
  double largest_release_step(const Discs &discs, const Eigen::VectorXd &x,
                              const Eigen::VectorXd &gradient);

  /// The paper's ALGORITHM QPQ: the quadratic program with disc constraints
  /// by an active set strategy with conjugate gradients.
  ///
  /// Step (a), while the free residual φ is not zero: conjugate gradients on
  /// the free nodes, x − α p; nodes that reach their circle stay there. Step
  /// (b): nodes that violate the KKT boundary condition (2) are released.
  ///
  /// As printed, step (b) waits until φ = o, which may zig-zag without end
  /// and has no proof of convergence. The variants repair this one measure at
  /// a time. As long as nodes are released along v_i the tightest disc holds
  /// up all others; from with_projected_release on, a release lowers the
  /// energy at every node by what a projected gradient step of fixed length
  /// does, and the method converges.
  class DiscActiveSet : public ActiveSetMethod
  {
  public:
    enum class Variant
    {
      /// stop at each boundary hit; release along v_i only when φ = o
      as_printed,
      /// ... a hit is followed by a projected gradient step of fixed length
      with_expansion,
      /// ... release when proportioning asks for it
      with_proportioning,
      /// ... release by the projected gradient step P(x − 1.9 r/‖A‖)
      with_projected_release,
      /// ... hits are first tried as P(x − α_cg p), kept if the energy falls
      robust,
      /// ... and so are releases as P(x − α r) with a spectral step α
      spectral
    };

    /// As ActiveSetMethod.
    DiscActiveSet(const SymmetricOperator &A, const Discs &discs, double norm,
                  Variant variant = Variant::spectral);

  protected:
    bool must_release(const Scaling &scaling, double tolerance) const override;

    void release() override;

    void expand(double alpha_cg, double alpha_feasible) override;

  private:
    const Discs &discs_;
    const Variant variant_;
  };
} // namespace stiction::qp
