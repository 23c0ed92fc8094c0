#pragma once

#include <stiction/qp/methods/dual_method.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/solvers/disc_active_set.h>
#include <stiction/qp/solvers/semismooth_newton.h>

#include <memory>
#include <optional>

namespace stiction
{
  /// The paper's ALGORITHM GS: block Gauss–Seidel between the normal contact
  /// forces (a bound-constrained quadratic program, its reference [1]) and the
  /// tangential ones (disc constraints, its ALGORITHM QPQ).
  ///
  /// The inner programs are solved only to a fixed part of the current error
  /// of the whole problem: solving them further changes what the next half
  /// sweep undoes. With Coulomb friction the slip bound follows the normal
  /// forces in every sweep; for successive approximations in the paper's
  /// order see CoulombFixedPoint.
  class GaussSeidel : public DualMethod
  {
  public:
    /// Estimates the norm of the normal block. The operator must outlive the
    /// method.
    ///
    /// @param variant how ALGORITHM QPQ is realised; without one the
    ///   quadratic program on discs is solved by the semismooth Newton method,
    ///   and by the spectral variant where that stands still.
    explicit GaussSeidel(
      const DualOperator &Q,
      std::optional<qp::DiscActiveSet::Variant> variant = std::nullopt);

    DualMethodResult solve(DualIterate &iterate, const Task &task) override;

    bool solves_coulomb() const override { return true; }

  private:
    /// λ_ν^(i) of ALGORITHM GS.
    void normal_half_sweep(DualIterate &iterate, const qp::SlipBound &slip_bound,
                           const qp::Scaling &scaling, double tolerance);

    /// λ_t^(i) of ALGORITHM GS.
    void tangential_half_sweep(DualIterate &iterate, const Eigen::VectorXd &slip_bound,
                               const qp::Scaling &scaling, double tolerance);

    /// A solver of a quadratic program, as a function of the point and its
    /// gradient.
    using Solver = std::function<void(Eigen::VectorXd &, Eigen::VectorXd &)>;

    /// Solves the quadratic program of one block and updates the gradient of
    /// the other one.
    void half_sweep(DualIterate &iterate, DualBlock block, const Solver &solver);

    void add(const qp::SolverRun &inner);

    const DualOperator &Q_;
    qp::SymmetricOperator normal_block_, tangential_block_;
    double normal_norm_;
    std::optional<double> tangential_norm_; ///< estimated when first needed
    std::optional<qp::DiscActiveSet::Variant> variant_;
    std::unique_ptr<qp::SemismoothNewton> disc_newton_;
    bool inner_converged_ = true; ///< the last program, or rounding ended it
  };

} // namespace stiction
