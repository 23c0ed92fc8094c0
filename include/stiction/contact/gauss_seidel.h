#ifndef stiction_contact_gauss_seidel_h
#define stiction_contact_gauss_seidel_h

#include <stiction/contact/dual_method.h>
#include <stiction/contact/dual_operator.h>
#include <stiction/qp/disc_active_set.h>

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
    /// Estimates the norms of the two diagonal blocks. The operator must
    /// outlive the method.
    ///
    /// @param variant how ALGORITHM QPQ is realised.
    explicit GaussSeidel(const DualOperator &Q,
                         qp::DiscActiveSet::Variant variant =
                           qp::DiscActiveSet::Variant::spectral);

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
    statistics() const override
    {
      return statistics_;
    }

  private:
    /// λ_ν^(i) of ALGORITHM GS.
    void
    normal_half_sweep(DualIterate &iterate,
                      const qp::Scaling &scaling,
                      double tolerance);

    /// λ_t^(i) of ALGORITHM GS.
    void
    tangential_half_sweep(DualIterate &iterate,
                          const Eigen::VectorXd &slip_bound,
                          const qp::Scaling &scaling,
                          double tolerance);

    /// Solves the quadratic program of one block, whose solver is given, and
    /// updates the gradient of the other one.
    void
    half_sweep(DualIterate &iterate,
               DualBlock block,
               qp::ActiveSetMethod &solver,
               const qp::Scaling &scaling,
               double tolerance);

    const DualOperator &Q_;
    DualOperatorBlock normal_block_, tangential_block_;
    double normal_norm_, tangential_norm_;
    qp::DiscActiveSet::Variant variant_;
    DualMethodStatistics statistics_;
  };

} // namespace stiction

#endif
