#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction::qp
{
  /// L(a) with L(a) b = a∘b = (a·b; a_0 b_t + b_0 a_t), the Jordan product of
  /// the second-order cone {‖a_t‖ ≤ a_0}.
  inline Eigen::Matrix3d product_with(const Eigen::Vector3d &a)
  {
    Eigen::Matrix3d L = a(0) * Eigen::Matrix3d::Identity();
    L.row(0)          = a.transpose();
    L.col(0)          = a;
    return L;
  }

  /// The largest s for which y + s d ≥ 0, for y ≥ 0.
  inline double step_to_zero(const double y, const double d)
  {
    return d < 0. ? -y / d : std::numeric_limits<double>::infinity();
  }

  /// The largest s for which y + s d is in the cone, for y inside.
  inline double step_to_cone(const Eigen::Vector3d &y, const Eigen::Vector3d &d)
  {
    const auto form = [](const Eigen::Vector3d &a, const Eigen::Vector3d &b) {
      return a(0) * b(0) - a(1) * b(1) - a(2) * b(2);
    };
    double step    = step_to_zero(y(0), d(0));
    const double a = form(d, d), b = form(y, d), c = form(y, y);
    const double discriminant = b * b - a * c; // of a s² + 2 b s + c
    if (discriminant < 0.)
      return step;
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    for (const double root : {q / a, c / q})
      if (root > 0.)
        step = std::min(step, root);
    return step;
  }
} // namespace stiction::qp
