#ifndef stiction_qp_proportioning_h
#define stiction_qp_proportioning_h

#include <stiction/qp/active_set_method.h>

namespace stiction::qp
{
  /// Conjugate gradients with proportioning and gradient projections for any
  /// feasible set: the paper's reference [1] for its first quadratic program
  /// (on half-lines), with the rules of MPRGP (Dostál and Schöberl 2005).
  ///
  /// A release is a proportioning step: on half-lines the exact minimiser
  /// along the chopped gradient, elsewhere the projected gradient step of
  /// fixed length. On half-lines this converges R-linearly at a rate given by
  /// the spectrum of A alone.
  class Proportioning : public ActiveSetMethod
  {
  public:
    /// As ActiveSetMethod; gamma > 0 weighs the free gradient against the
    /// chopped one.
    Proportioning(const SymmetricOperator &A,
                  const FeasibleSet &set,
                  double norm,
                  double gamma = 1.);

  protected:
    bool
    must_release(const Scaling &scaling, double tolerance) const override;

    void
    release() override;

  private:
    const double gamma_;
  };
} // namespace stiction::qp

#endif
