#ifndef stiction_contact_gauss_seidel_h
#define stiction_contact_gauss_seidel_h

#include <stiction/contact/given_friction.h>
#include <stiction/contact/schur_complement.h>
#include <stiction/qp/active_set_method.h>

namespace stiction
{
  /// The paper's ALGORITHM GS: block Gauss–Seidel between the normal contact
  /// forces (a bound-constrained quadratic program, its reference [1]) and the
  /// tangential ones (disc constraints, its ALGORITHM QPQ).
  ///
  /// The inner programs are solved only to a fixed part of the current error
  /// of the whole problem: solving them further changes what the next half
  /// sweep undoes.
  class GaussSeidel : public GivenFrictionSolver
  {
  public:
    /// Estimates the norms of the two diagonal blocks. The Schur complement
    /// must outlive the solver.
    explicit GaussSeidel(const SchurComplement &schur);

    GivenFrictionResult
    solve(DualIterate &iterate,
          const Eigen::VectorXd &slip_bound,
          const qp::Scaling &scaling,
          const StoppingRule &rule,
          const Observer &observer) override;

    /// Sums over all inner solves so far.
    const qp::ActiveSetStatistics &
    normal_statistics() const
    {
      return normal_statistics_;
    }
    const qp::ActiveSetStatistics &
    tangential_statistics() const
    {
      return tangential_statistics_;
    }

  private:
    void
    make_feasible(DualIterate &iterate,
                  const Eigen::VectorXd &slip_bound) const;

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

    const SchurComplement &schur_;
    SchurBlock normal_block_, tangential_block_;
    double normal_norm_, tangential_norm_;
    qp::ActiveSetStatistics normal_statistics_, tangential_statistics_;
  };
} // namespace stiction

#endif
