#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/rotated_squares.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace stiction::qp
{
  RotatedSquares::RotatedSquares(const unsigned int r, Eigen::VectorXd slip_bound)
    : n_squares_(r)
    , slip_bound_(std::move(slip_bound))
  {
    if (r == 0)
      throw std::invalid_argument("at least one square must replace a circle");
    for (const double g : slip_bound_)
      if (!(g >= 0.))
        throw std::invalid_argument("the slip bound must be >= 0");

    const double pi = std::acos(-1.);
    factor_         = r == 1 ? 1. : std::tan(pi / (4. * r));
    // The numbers of the first quadrant everywhere, so that the polygon has all
    // its symmetries to the last bit.
    for (unsigned int k = 0; k < 4 * r; ++k)
      {
        const unsigned int quadrant = k / r, part = k % r;
        const double angle = part * pi / (2. * r);
        const double c = std::cos(angle), s = part == 0 ? 0. : std::sin(angle);
        cosine_.push_back(quadrant == 0   ? c
                          : quadrant == 1 ? -s
                          : quadrant == 2 ? -c
                                          : s);
        sine_.push_back(quadrant == 0 ? s : quadrant == 1 ? c : quadrant == 2 ? -s : -c);
      }
  }

  Eigen::VectorXd RotatedSquares::half_widths() const { return factor_ * slip_bound_; }

  Eigen::VectorXd RotatedSquares::to_forces(const Eigen::VectorXd &unknowns) const
  {
    eigen_assert(unknowns.size() == n_unknowns());
    const Eigen::Index m   = n_nodes();
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * m);
    forces.head(m)         = unknowns.head(m);
    for (unsigned int j = 0; j < n_squares_; ++j)
      {
        const auto mu_x = unknowns.segment((1 + 2 * j) * m, m);
        const auto mu_y = unknowns.segment((2 + 2 * j) * m, m);
        forces.segment(m, m) += cosine_[j] * mu_x + sine_[j] * mu_y;
        forces.tail(m) += cosine_[j] * mu_y - sine_[j] * mu_x;
      }
    return forces;
  }

  Eigen::VectorXd RotatedSquares::pull_back(const Eigen::VectorXd &gradient) const
  {
    const Eigen::Index m = n_nodes();
    eigen_assert(gradient.size() == 3 * m);
    const auto r1 = gradient.segment(m, m), r2 = gradient.tail(m);
    Eigen::VectorXd result(n_unknowns());
    result.head(m) = gradient.head(m);
    for (unsigned int j = 0; j < n_squares_; ++j)
      {
        result.segment((1 + 2 * j) * m, m) = cosine_[j] * r1 - sine_[j] * r2;
        result.segment((2 + 2 * j) * m, m) = sine_[j] * r1 + cosine_[j] * r2;
      }
    return result;
  }

  Eigen::VectorXd RotatedSquares::lift(const Eigen::VectorXd &forces) const
  {
    const Eigen::Index m = n_nodes();
    eigen_assert(forces.size() == 3 * m);
    const int r = static_cast<int>(n_squares_);
    Eigen::VectorXd unknowns(n_unknowns());
    for (Eigen::Index i = 0; i < m; ++i)
      {
        unknowns(i)     = is_tied(slip_bound_(i)) ? forces(i) : std::max(forces(i), 0.);
        const double x1 = forces(i + m), x2 = forces(i + 2 * m);
        // The edge, in units of π/(2r) from the first axis; then the projected
        // point by its parts along the normal and along the edge.
        int edge = 0;
        for (int k = 1; k < 4 * r; ++k)
          if (cosine_[k] * x1 + sine_[k] * x2 > cosine_[edge] * x1 + sine_[edge] * x2)
            edge = k;
        const double normal =
          std::min(cosine_[edge] * x1 + sine_[edge] * x2, slip_bound_(i));
        const double share   = factor_ * normal;
        const double tangent = cosine_[edge] * x2 - sine_[edge] * x1;
        const double along   = std::max(-share, std::min(tangent, share));
        // R_jᵀe_x and R_jᵀe_y point at −j and r − j of those units (j from 0).
        for (int j = 0; j < r; ++j)
          for (const int component : {0, 1})
            {
              const int angle = (component * r - j - edge + 8 * r) % (4 * r);
              unknowns(i + (1 + 2 * j + component) * m) = angle == r       ? along
                                                          : angle == 3 * r ? -along
                                                          : angle < r || angle > 3 * r
                                                            ? share
                                                            : -share;
            }
      }
    return unknowns;
  }
} // namespace stiction::qp
