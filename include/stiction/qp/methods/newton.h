#pragma once

#include <stiction/qp/methods/dual_method.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/solvers/semismooth_newton.h>

#include <memory>

namespace stiction
{
  /// The semismooth Newton method on the dual problem, for given and for
  /// Coulomb friction alike, with methods to fall back on.
  ///
  /// Newton steps solve their systems by products with Q, and stand still where
  /// Q is ill-conditioned, above all with bodies that are held weakly. If Q is
  /// a matrix of an order that can be factorised, they are solved directly from
  /// then on, and where that is not enough, the interior point method has its
  /// turn, which does not depend on where it starts. Without a matrix, or if it
  /// stands still itself (it may with Coulomb friction alone), a stretch of
  /// another method follows: with given friction the monolithic active set
  /// method, whose energy falls in every step; with Coulomb friction successive
  /// approximations, each solved as a problem of given friction by this method.
  /// Then Newton resumes from there. Where there may be several solutions, the
  /// interior point method is the last resort: the approximations lead to the
  /// one that all other methods find.
  class Newton : public DualMethod
  {
  public:
    /// The operator must outlive the method.
    ///
    /// @param max_steps_in_a_run of Newton before falling back; finite only
    ///   where a test forces the fallbacks.
    explicit Newton(const DualOperator &Q, unsigned int max_steps_in_a_run = 1000);

    DualMethodResult solve(DualIterate &iterate, const Task &task) override;

    bool solves_coulomb() const override { return true; }

    DualMethodStatistics statistics() const override;

  private:
    /// A call of solve(): its arguments and how far it came.
    struct Run;

    bool can_factorize() const;

    /// The parts of solve().
    void run_newton(Run &run);
    void run_interior_point(Run &run);
    void fall_back(Run &run);

    const DualOperator &Q_;
    qp::SymmetricOperator block_;
    qp::SemismoothNewton newton_;
    const unsigned int max_steps_in_a_run_;
    bool is_direct_ = false;               ///< Newton's systems, by LU factors
    std::unique_ptr<DualMethod> fallback_; ///< made when first needed
  };
} // namespace stiction
