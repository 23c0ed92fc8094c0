#include <stiction/qp/operators/nodal_scaling.h>
#include <stiction/qp/operators/scaled_operator.h>

namespace stiction::qp
{
  ScaledOperator::ScaledOperator(const SymmetricOperator &A, const NodalScaling &scaling)
    : A_(A)
    , scaling_(scaling)
  {
    eigen_assert(scaling.n_nodes() == 0 ? A.size() == 0
                                        : A.size() % scaling.n_nodes() == 0);
  }

  Eigen::Index ScaledOperator::size() const
  {
    return A_.size();
  }

  void ScaledOperator::apply(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    A_.vmult(dst, scaling_.times(src));
    dst = scaling_.times(dst);
  }
} // namespace stiction::qp
