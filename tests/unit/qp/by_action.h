#pragma once

#include <stiction/qp/operators/dual_operator.h>

#include "qp_tests.h"

namespace qp_tests
{
  using namespace stiction;

  /// A dual operator that is known by its action only.
  class ByAction : public DualOperator
  {
  public:
    ByAction(const MatrixXd &Q, const VectorXd &h)
      : DualOperator(h.size() / 3)
      , dense_(Q, h)
    {
      set_right_hand_side(h);
    }

  protected:
    VectorXd compute_nodal_compliance() const override
    {
      return dense_.nodal_compliance();
    }

    void apply(const DualBlock rows, const DualBlock columns, VectorXd &dst,
               const VectorXd &src) const override
    {
      dense_.vmult(rows, columns, dst, src);
    }

  private:
    const DenseDualOperator dense_;
  };
} // namespace qp_tests
