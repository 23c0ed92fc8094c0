#include <stiction/qp/sets/feasible_set.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace stiction::qp
{
  namespace
  {
    // A projected point sits on its circle or bound only up to rounding. Inside by
    // less than this part of the radius counts as on it; were it missed, the
    // node would be moved by conjugate gradients into a zero-length step.
    constexpr double on_boundary = 1. - 1e-12;
  } // namespace

  FeasibleSet::FeasibleSet(const Eigen::Index n_nodes, const unsigned int n_components)
    : n_nodes_(n_nodes)
    , n_components_(n_components)
  {
  }

  double FeasibleSet::natural_residual(const Eigen::VectorXd &x,
                                       const Eigen::VectorXd &gradient,
                                       const Scaling &scaling) const
  {
    eigen_assert(scaling.force.size() == n_nodes_);
    eigen_assert(scaling.weight.size() == 0 || scaling.weight.size() == n_nodes_);

    const Eigen::VectorXd force_per_weight =
      scaling.weight.size() == 0 ? scaling.force
                                 : scaling.force.cwiseQuotient(scaling.weight);
    Eigen::VectorXd y(size());
    for (unsigned int c = 0; c < n_components_; ++c)
      y.segment(c * n_nodes_, n_nodes_) =
        x.segment(c * n_nodes_, n_nodes_) -
        force_per_weight.cwiseProduct(gradient.segment(c * n_nodes_, n_nodes_)) /
          scaling.displacement;
    project(y);

    double largest = 0.;
    for (Eigen::Index i = 0; i < n_nodes_; ++i)
      {
        double square = 0.;
        for (unsigned int c = 0; c < n_components_; ++c)
          {
            const Eigen::Index k = i + c * n_nodes_;
            square += (x(k) - y(k)) * (x(k) - y(k));
          }
        const double residual = std::sqrt(square) / scaling.force(i);
        if (std::isnan(residual))
          return residual; // std::max would drop it
        largest = std::max(largest, residual);
      }
    return largest;
  }

  // ------------------------------------------------------------ Intervals

  Intervals::Intervals(const Eigen::VectorXd &half_widths, const unsigned int n_more)
    : FeasibleSet(half_widths.size(), 1 + n_more)
    , upper_(half_widths.replicate(1 + n_more, 1))
    , lower_(-upper_)
  {
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        if (!is_tied(half_widths(i)))
          lower_(i) = 0.;
        upper_(i) = std::numeric_limits<double>::infinity();
      }
  }

  void Intervals::project(Eigen::VectorXd &x) const
  {
    eigen_assert(x.size() == size());
    for (Eigen::Index k = 0; k < size(); ++k) // a NaN stays one
      if (x(k) < lower_(k))
        x(k) = lower_(k);
      else if (x(k) > upper_(k))
        x(k) = upper_(k);
  }

  void Intervals::split(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                        const double step, Eigen::VectorXd &free,
                        Eigen::VectorXd &chopped) const
  {
    eigen_assert(x.size() == size() && gradient.size() == size());
    free.setZero(size());
    chopped.setZero(size());
    for (Eigen::Index k = 0; k < size(); ++k)
      {
        // What points inwards, no further than to the opposite bound; nowhere
        // in an interval that is a point.
        const double longest = (upper_(k) - lower_(k)) / step;
        if (x(k) <= on_boundary * lower_(k))
          chopped(k) = std::max(std::min(gradient(k), 0.), -longest);
        else if (x(k) >= on_boundary * upper_(k))
          chopped(k) = std::min(std::max(gradient(k), 0.), longest);
        else
          free(k) = gradient(k);
      }
  }

  double Intervals::largest_feasible_step(const Eigen::VectorXd &x,
                                          const Eigen::VectorXd &d) const
  {
    double alpha = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < size(); ++k)
      if (d(k) != 0.)
        {
          const double room = d(k) > 0. ? upper_(k) - x(k) : x(k) - lower_(k);
          alpha             = std::min(alpha, std::max(room, 0.) / std::abs(d(k)));
        }
    return alpha;
  }

  HalfLinesTimesBoxes::HalfLinesTimesBoxes(const Eigen::VectorXd &half_widths,
                                           const unsigned int n_intervals)
    : Intervals(half_widths, n_intervals)
  {
    if (!(half_widths.array() >= 0.).all())
      throw std::invalid_argument("the half-width of a box must be >= 0");
  }

  // ---------------------------------------------------------------- Discs

  Discs::Discs(Eigen::VectorXd radii)
    : FeasibleSet(radii.size(), 2)
    , radii_(std::move(radii))
  {
    if (!(radii_.array() >= 0.).all())
      throw std::invalid_argument("the radius of a disc must be >= 0");
  }

  void Discs::project(Eigen::VectorXd &x) const
  {
    eigen_assert(x.size() == size());
    const Eigen::Index m = n_nodes();
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const double norm = std::hypot(x(i), x(i + m));
        if (norm > radii_(i))
          {
            x(i) *= radii_(i) / norm;
            x(i + m) *= radii_(i) / norm;
          }
      }
  }

  bool Discs::is_active(const Eigen::VectorXd &x, const Eigen::Index i) const
  {
    return std::hypot(x(i), x(i + n_nodes())) >= on_boundary * radii_(i);
  }

  void Discs::split(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                    const double step, Eigen::VectorXd &free,
                    Eigen::VectorXd &chopped) const
  {
    eigen_assert(x.size() == size() && gradient.size() == size());
    const Eigen::Index m = n_nodes();

    Eigen::VectorXd projected = x - step * gradient;
    project(projected);

    free.setZero(size());
    chopped.setZero(size());
    for (Eigen::Index i = 0; i < m; ++i)
      for (const Eigen::Index k : {i, i + m})
        if (is_active(x, i))
          chopped(k) = (x(k) - projected(k)) / step;
        else
          free(k) = gradient(k);
  }

  double Discs::largest_feasible_step(const Eigen::VectorXd &x,
                                      const Eigen::VectorXd &d) const
  {
    const Eigen::Index m = n_nodes();
    double alpha         = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const double a = d(i) * d(i) + d(i + m) * d(i + m);
        if (a == 0. || is_tied(radii_(i)))
          continue;
        // Positive root of a α² + 2 b α − c = 0, in the form that does not
        // cancel. c is how far inside the node is, never negative.
        const double b    = x(i) * d(i) + x(i + m) * d(i + m);
        const double r    = std::hypot(x(i), x(i + m));
        const double c    = std::max(0., (radii_(i) - r) * (radii_(i) + r));
        const double root = std::sqrt(b * b + a * c);
        alpha             = std::min(alpha, b > 0. ? c / (b + root) : (root - b) / a);
      }
    return alpha;
  }

  // -------------------------------------------------- HalfLinesTimesDiscs

  HalfLinesTimesDiscs::HalfLinesTimesDiscs(Eigen::VectorXd radii)
    : FeasibleSet(radii.size(), 3)
    , half_lines_(radii)
    , discs_(std::move(radii))
  {
  }

  void HalfLinesTimesDiscs::project(Eigen::VectorXd &x) const
  {
    eigen_assert(x.size() == size());
    const Eigen::Index m = n_nodes();
    Eigen::VectorXd xn = x.head(m), xt = x.tail(2 * m);
    half_lines_.project(xn);
    discs_.project(xt);
    x << xn, xt;
  }

  void HalfLinesTimesDiscs::split(const Eigen::VectorXd &x,
                                  const Eigen::VectorXd &gradient, const double step,
                                  Eigen::VectorXd &free, Eigen::VectorXd &chopped) const
  {
    const Eigen::Index m = n_nodes();
    Eigen::VectorXd free_n, chopped_n, free_t, chopped_t;
    half_lines_.split(x.head(m), gradient.head(m), step, free_n, chopped_n);
    discs_.split(x.tail(2 * m), gradient.tail(2 * m), step, free_t, chopped_t);
    free.resize(size());
    chopped.resize(size());
    free << free_n, free_t;
    chopped << chopped_n, chopped_t;
  }

  double HalfLinesTimesDiscs::largest_feasible_step(const Eigen::VectorXd &x,
                                                    const Eigen::VectorXd &d) const
  {
    const Eigen::Index m = n_nodes();
    return std::min(half_lines_.largest_feasible_step(x.head(m), d.head(m)),
                    discs_.largest_feasible_step(x.tail(2 * m), d.tail(2 * m)));
  }
} // namespace stiction::qp
