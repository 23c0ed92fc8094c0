#pragma once

#include <stiction/qp/solvers/solver_run.h>
#include <stiction/qp/solvers/spectral_step.h>

#include <Eigen/Core>

#include <functional>
#include <utility>

namespace stiction::qp
{
  class FeasibleSet;
  class SymmetricOperator;
  struct Scaling;

  /// min ½ xᵀAx − xᵀb over a feasible set, by conjugate gradients on the nodes
  /// inside their set (the free ones) and two further kinds of steps: an
  /// expansion step, when conjugate gradients would leave the set, and a
  /// release step, when the nodes on the boundary want to move more than the
  /// free ones do.
  ///
  /// The frame is that of Dostál and Schöberl's MPRGP; what an expansion and
  /// a release are is left to the derived class. The iteration works with the
  /// gradient r = Ax − b only: the change of the energy along d is
  /// dᵀr + ½ dᵀAd, so b itself is never needed. A may be singular if the set
  /// is bounded where A is.
  ///
  /// No step raises the energy, up to rounding; with assertions switched on
  /// every step is checked.
  class ActiveSetMethod
  {
  public:
    /// The operator and the set must outlive this object. norm is an upper
    /// estimate of the largest eigenvalue of A, see spectral_norm(). One that
    /// is too small is noticed and corrected for good: it costs products.
    ActiveSetMethod(const SymmetricOperator &A, const FeasibleSet &set, double norm);
    virtual ~ActiveSetMethod() = default;

    /// Called before each step with the products so far, the point and its
    /// natural residual.
    using Observer = std::function<void(unsigned int multiplications,
                                        const Eigen::VectorXd &x, double residual)>;
    void set_observer(Observer observer) { observer_ = std::move(observer); }

    /// Moves the feasible x until its natural residual is at most tolerance,
    /// or max_multiplications products were made.
    ///
    /// @param x in: a feasible point; out: the solution, feasible. Length
    ///   A.size().
    /// @param gradient in: Ax − b at the given x; out: at the returned one.
    SolverRun solve(Eigen::VectorXd &x, Eigen::VectorXd &gradient, const Scaling &scaling,
                    double tolerance, unsigned int max_multiplications);

  protected:
    /// Whether the boundary nodes are to be released before the free nodes
    /// are improved further. @p tolerance is the one asked of solve().
    virtual bool must_release(const Scaling &scaling, double tolerance) const = 0;

    /// Changes x_ and gradient_ by a step that lets nodes leave the boundary.
    virtual void release() = 0;

    /// Changes x_ and gradient_ when the conjugate gradient step −α_cg p
    /// leaves the set at −α_feasible p. Unless overridden: the projected step
    /// P(x − α_cg p) if it lowers the energy, otherwise standard_expansion().
    virtual void expand(double alpha_cg, double alpha_feasible);

    /// The step to the boundary followed by a projected gradient step of fixed
    /// length, which always lowers the energy; one product.
    void standard_expansion(double alpha_feasible);

    /// Goes to the boundary: x − α_feasible p; needs no product.
    void go_to_boundary(double alpha_feasible);

    /// Moves by P(x − fixed_step_·direction) − x, direction being the gradient
    /// or its free part; one product. If the step turns out to be longer than
    /// 2/‖A‖, it is shortened and done again, one product each time.
    void fixed_projected_step(const Eigen::VectorXd &direction);

    /// Moves by P(x − step·direction) − x, but only if the energy falls, up to
    /// rounding; one product.
    bool guarded_projected_step(double step, const Eigen::VectorXd &direction);

    /// The same along the gradient, with a SpectralStep.
    bool spectral_release();

    /// Recomputes free_ and chopped_ at x_.
    void split();

    /// Proportioning: the boundary asks for more than the free nodes,
    /// ‖chopped‖² > Γ² (reduced free)ᵀ(free).
    bool is_disproportionate(double gamma) const;

    const SymmetricOperator &A_;
    const FeasibleSet &set_;
    double fixed_step_; ///< 1.9/norm: below 2/‖A‖

    Eigen::VectorXd x_, gradient_;   ///< the iterate and Ax − b there
    Eigen::VectorXd free_, chopped_; ///< the two parts of the gradient
    Eigen::VectorXd p_, Ap_;         ///< conjugate direction and its image

  private:
    Observer observer_;
    SpectralStep spectral_step_; ///< of this solve()

    /// A step that is no release: conjugate gradients, or an expansion where they
    /// leave the set.
    void improve(SolverRun &statistics);

    Eigen::VectorXd step_to_projection(double step,
                                       const Eigen::VectorXd &direction) const;
  };
} // namespace stiction::qp
