#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include <algorithm>

namespace stiction::qp
{
  Proportioning::Proportioning(const SymmetricOperator &A, const FeasibleSet &set,
                               const double norm, const ProportioningOptions &options)
    : ActiveSetMethod(A, set, norm)
    , options_(options)
  {
  }

  bool Proportioning::must_release(const Scaling &, const double) const
  {
    return is_disproportionate(options_.gamma);
  }

  void Proportioning::release()
  {
    if (options_.spectral_release && spectral_release())
      return;
    if (set_.n_components() > 1)
      {
        // Bounded sets: a straight step would lift sliding nodes off their
        // circle, and the tightest of them would hold up all others.
        fixed_projected_step(gradient_);
        return;
      }
    const Eigen::VectorXd d = -chopped_;
    Eigen::VectorXd Ad;
    A_.vmult(Ad, d);
    const double curvature = d.dot(Ad);
    if (!(curvature > 0.))
      return;
    const double alpha =
      std::min(-gradient_.dot(d) / curvature, set_.largest_feasible_step(x_, d));
    x_ += alpha * d;
    gradient_ += alpha * Ad;
    set_.project(x_); // removes rounding only
  }
} // namespace stiction::qp
