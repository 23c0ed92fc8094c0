#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/slip_bound.h>

#include <utility>

namespace stiction::qp
{
  SymmetricOperator::SymmetricOperator(const Eigen::Index size, Product product)
    : size_(size)
    , product_(std::move(product))
  {
  }

  void SymmetricOperator::vmult(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    eigen_assert(src.size() == size());
    ++n_multiplications_;
    product_(dst, src);
  }

  void move_to(const Eigen::VectorXd &target, Eigen::VectorXd &x,
               Eigen::VectorXd &gradient, const SymmetricOperator &A)
  {
    const Eigen::VectorXd d = target - x;
    if (d.isZero(0.))
      return;
    Eigen::VectorXd Ad;
    A.vmult(Ad, d);
    x = target;
    gradient += Ad;
  }

  void make_feasible(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                     const SymmetricOperator &A, const SlipBound &slip_bound)
  {
    Eigen::VectorXd projected = x;
    project(projected, slip_bound);
    move_to(projected, x, gradient, A);
  }
} // namespace stiction::qp
