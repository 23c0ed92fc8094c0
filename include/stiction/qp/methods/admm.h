#ifndef stiction_qp_methods_admm_h
#define stiction_qp_methods_admm_h

#include <stiction/qp/methods/dual_method.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/solvers/alternating_directions.h>

namespace stiction
{
  /// The alternating direction method of multipliers on the dual problem, for
  /// given and Coulomb friction: a few dozen iterations on any mesh, at the
  /// price of dense Cholesky factorisations of order 3m.
  class Admm : public DualMethod
  {
  public:
    /// The operator must outlive the method. Throws std::invalid_argument if
    /// it has no matrix.
    explicit Admm(const DualOperator &Q);

    DualMethodResult solve(DualIterate &iterate, const qp::SlipBound &slip_bound,
                           const qp::Scaling &scaling, const StoppingRule &rule,
                           const Observer &observer) override;

    bool solves_coulomb() const override { return true; }

    DualMethodStatistics statistics() const override { return statistics_; }

  private:
    DualOperatorBlock block_;
    qp::AlternatingDirections solver_;
    DualMethodStatistics statistics_;
  };
} // namespace stiction

#endif
