#ifndef stiction_qp_operators_squares_operator_h
#define stiction_qp_operators_squares_operator_h

#include <stiction/qp/operators/symmetric_operator.h>

namespace stiction::qp
{
  class RotatedSquares;

  /// CᵀQC: the Hessian in the box unknowns of RotatedSquares, around a Hessian
  /// Q of order 3m. Positive semidefinite; definite for one square. A product
  /// with it counts as one with Q, too. Both arguments must outlive this
  /// object.
  class SquaresOperator : public SymmetricOperator
  {
  public:
    SquaresOperator(const SymmetricOperator &Q, const RotatedSquares &squares);

    Eigen::Index size() const override;

  protected:
    void apply(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const override;

  private:
    const SymmetricOperator &Q_;
    const RotatedSquares &squares_;
  };
} // namespace stiction::qp

#endif
