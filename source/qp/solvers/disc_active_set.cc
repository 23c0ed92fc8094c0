#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/disc_active_set.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction::qp
{
  Eigen::VectorXd unbalanced_boundary_residual(const Discs &discs,
                                               const Eigen::VectorXd &x,
                                               const Eigen::VectorXd &gradient)
  {
    const Eigen::Index m = discs.n_nodes();
    Eigen::VectorXd v    = Eigen::VectorXd::Zero(2 * m);
    for (Eigen::Index i = 0; i < m; ++i)
      if (discs.radii()(i) > 0. && discs.is_active(x, i))
        {
          const double ratio =
            std::hypot(gradient(i), gradient(i + m)) / discs.radii()(i);
          v(i)     = -gradient(i) - ratio * x(i);
          v(i + m) = -gradient(i + m) - ratio * x(i + m);
        }
    return v;
  }

  double largest_release_step(const Discs &discs, const Eigen::VectorXd &x,
                              const Eigen::VectorXd &gradient)
  {
    const Eigen::Index m    = discs.n_nodes();
    const Eigen::VectorXd v = unbalanced_boundary_residual(discs, x, gradient);
    double alpha            = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < m; ++i)
      if (v(i) != 0. || v(i + m) != 0.)
        alpha =
          std::min(alpha, discs.radii()(i) / std::hypot(gradient(i), gradient(i + m)));
    return alpha;
  }

  DiscActiveSet::DiscActiveSet(const SymmetricOperator &A, const Discs &discs,
                               const double norm, const Variant variant)
    : ActiveSetMethod(A, discs, norm)
    , discs_(discs)
    , variant_(variant)
  {
  }

  bool DiscActiveSet::must_release(const Scaling &scaling, const double tolerance) const
  {
    if (variant_ >= Variant::with_proportioning)
      return is_disproportionate(1.);
    // "φ = o" to half the accuracy asked for: the other half is the boundary's
    return discs_.natural_residual(x_, free_, scaling) <= 0.5 * tolerance;
  }

  void DiscActiveSet::release()
  {
    if (variant_ == Variant::spectral && spectral_release())
      return;
    if (variant_ >= Variant::with_projected_release)
      {
        fixed_projected_step(gradient_);
        return;
      }

    const Eigen::VectorXd v = unbalanced_boundary_residual(discs_, x_, gradient_);
    Eigen::VectorXd Av;
    A_.vmult(Av, v);
    const double curvature = v.dot(Av);
    if (!(curvature > 0.)) // nothing on the boundary is out of balance
      return;
    // −vᵀr is ½‖v‖² on the circle; computed as written it would cancel
    const double alpha = std::min(0.5 * v.squaredNorm() / curvature,
                                  largest_release_step(discs_, x_, gradient_));
    x_ += alpha * v;
    gradient_ += alpha * Av;
    discs_.project(x_); // removes rounding only
  }

  void DiscActiveSet::expand(const double alpha_cg, const double alpha_feasible)
  {
    if (variant_ >= Variant::robust)
      {
        ActiveSetMethod::expand(alpha_cg, alpha_feasible);
        return;
      }
    if (variant_ == Variant::as_printed)
      go_to_boundary(alpha_feasible);
    else
      standard_expansion(alpha_feasible);
  }
} // namespace stiction::qp
