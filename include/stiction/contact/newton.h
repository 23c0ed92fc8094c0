#ifndef stiction_contact_newton_h
#define stiction_contact_newton_h

#include <stiction/contact/dual_method.h>
#include <stiction/contact/dual_operator.h>
#include <stiction/contact/monolithic.h>
#include <stiction/qp/semismooth_newton.h>

#include <memory>

namespace stiction
{
  /// The semismooth Newton method on the dual problem, for given and for
  /// Coulomb friction alike, with methods to fall back on.
  ///
  /// Newton steps solve their systems by products with Q, and stand still where
  /// Q is ill-conditioned, above all with bodies that are held weakly. Then
  /// comes the interior point method, if Q is a matrix and of an order that can
  /// be factorised. If there is none, or if it stands still itself, a stretch
  /// of a method with a proof follows: with given friction the monolithic
  /// active set method, whose energy falls in every step; with Coulomb friction
  /// one successive approximation, solved as a problem of given friction. Then
  /// Newton resumes from there.
  class Newton : public DualMethod
  {
  public:
    /// The operator must outlive the method.
    ///
    /// @param max_steps_in_a_run of Newton before falling back; finite only
    ///   where a test forces the fallbacks.
    explicit Newton(const DualOperator &Q,
                    unsigned int max_steps_in_a_run = 1000);

    DualMethodResult
    solve(DualIterate &iterate,
          const qp::SlipBound &slip_bound,
          const qp::Scaling &scaling,
          const StoppingRule &rule,
          const Observer &observer) override;

    bool
    solves_coulomb() const override
    {
      return true;
    }

    DualMethodStatistics
    statistics() const override;

  private:
    /// A call of solve(): its arguments and how far it came.
    struct Run;

    bool
    has_interior_point() const;

    /// The parts of solve().
    void
    run_newton(Run &run);
    void
    run_interior_point(Run &run);
    void
    fall_back(Run &run);

    const DualOperator &Q_;
    DualOperatorBlock block_;
    qp::SemismoothNewton newton_;
    const unsigned int max_steps_in_a_run_;
    bool has_stood_still_ = false;           ///< Newton, in any call
    std::unique_ptr<Monolithic> monolithic_; ///< made when first needed
    DualMethodStatistics statistics_;
  };
} // namespace stiction

#endif
