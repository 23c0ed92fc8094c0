#ifndef stiction_qp_operators_scaled_operator_h
#define stiction_qp_operators_scaled_operator_h

#include <stiction/qp/operators/symmetric_operator.h>

namespace stiction::qp
{
  class NodalScaling;

  /// D A D: the Hessian after the change of variables x = D y. A product with
  /// it counts as one with A, too. Both arguments must outlive this object.
  class ScaledOperator : public SymmetricOperator
  {
  public:
    ScaledOperator(const SymmetricOperator &A, const NodalScaling &scaling);

    Eigen::Index size() const override;

  protected:
    void apply(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const override;

  private:
    const SymmetricOperator &A_;
    const NodalScaling &scaling_;
  };
} // namespace stiction::qp

#endif
