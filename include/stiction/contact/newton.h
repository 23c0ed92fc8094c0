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
  /// A Newton run that stands still is followed by a stretch of a method with
  /// a proof: with given friction the monolithic active set method, whose
  /// energy falls in every step; with Coulomb friction one successive
  /// approximation, solved as a problem of given friction. Then Newton
  /// resumes from there.
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
    const DualOperator &Q_;
    DualOperatorBlock block_;
    qp::SemismoothNewton newton_;
    const unsigned int max_steps_in_a_run_;
    std::unique_ptr<Monolithic> monolithic_; ///< made when first needed
    DualMethodStatistics statistics_;
  };
} // namespace stiction

#endif
