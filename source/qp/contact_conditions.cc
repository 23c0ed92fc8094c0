#include <stiction/qp/contact_conditions.h>
#include <stiction/qp/contact_scales.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace stiction
{
  namespace
  {
    // std::max that keeps a NaN
    void raise(double &largest, const double value)
    {
      if (!(value <= largest))
        largest = std::isnan(largest) ? largest : value;
    }
  } // namespace

  ContactConditions::ContactConditions(Eigen::VectorXd lambda, Eigen::VectorXd slip_bound)
    : lambda_(std::move(lambda))
    , slip_bound_(std::move(slip_bound))
  {
  }

  ContactConditions::ContactConditions(Eigen::VectorXd lambda, Eigen::VectorXd gradient,
                                       Eigen::VectorXd slip_bound, qp::Scaling scaling)
    : lambda_(std::move(lambda))
    , slip_bound_(std::move(slip_bound))
    , gradient_(std::move(gradient))
    , scaling_(std::move(scaling))
  {
    compute_contact_figures();
  }

  double ContactConditions::normal_residual() const
  {
    double largest  = 0.;
    bool is_pressed = false;
    for (Eigen::Index i = 0; i < slip_bound_.size(); ++i)
      if (!qp::is_tied(slip_bound_(i)))
        {
          const double pressure = lambda_(i) / scaling_.force(i);
          const double gap      = gradient_(i) / scaling_.displacement_at(i);
          raise(largest, std::abs(pressure - std::max(pressure - gap, 0.)));
          is_pressed = is_pressed || pressure > 0.;
        }
    return is_pressed ? largest : std::numeric_limits<double>::infinity();
  }

  void ContactConditions::compute_contact_figures()
  {
    const Eigen::Index m = slip_bound_.size();
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const double force = scaling_.force(i);
        const double u0    = scaling_.displacement_at(i);
        const double gap   = gradient_(i);
        const Eigen::Vector2d lambda_t(lambda_(i + m), lambda_(i + 2 * m));
        const Eigen::Vector2d slip(-gradient_(i + m), -gradient_(i + 2 * m));

        if (qp::is_tied(slip_bound_(i)))
          {
            // the KKT residual has the slip
            raise(contact_figures_.penetration, std::abs(gap) / u0);
            continue;
          }
        raise(contact_figures_.penetration, -gap / u0);
        raise(contact_figures_.complementarity,
              std::abs(lambda_(i)) / force * std::min(std::abs(gap) / u0, 1.));
        raise(contact_figures_.cone_violation, -lambda_(i) / force);
        raise(contact_figures_.cone_violation,
              (lambda_t.norm() - slip_bound_(i)) / force);
        if (slip.norm() > 1e-6 * u0 && lambda_t.norm() > 1e-6 * force)
          raise(contact_figures_.slip_angle,
                std::atan2(std::abs(lambda_t(0) * slip(1) - lambda_t(1) * slip(0)),
                           lambda_t.dot(slip)) *
                  180. / M_PI);
      }
    if (!lambda_.allFinite() || slip_bound_.hasNaN())
      {
        contact_figures_.kkt_residual =
          std::numeric_limits<double>::quiet_NaN(); // no set has such a radius
        return;
      }
    contact_figures_.kkt_residual =
      qp::HalfLinesTimesDiscs(slip_bound_).natural_residual(lambda_, gradient_, scaling_);
  }

  std::vector<std::pair<std::string, double>> ContactConditions::deciding_figures() const
  {
    return {{"kkt_residual", contact_figures_.kkt_residual},
            {"penetration", contact_figures_.penetration},
            {"complementarity", contact_figures_.complementarity},
            {"cone_violation", contact_figures_.cone_violation}};
  }

  bool ContactConditions::converged(const double tolerance) const
  {
    const auto figures = deciding_figures();
    return std::all_of(figures.begin(), figures.end(),
                       [&](const auto &figure) { return figure.second <= tolerance; });
  }

  std::pair<std::string, double> ContactConditions::worst_figure() const
  {
    std::pair<std::string, double> worst{"", -1.};
    for (const auto &figure : deciding_figures())
      if (!std::isnan(worst.second) && !(figure.second <= worst.second))
        worst = figure;
    return worst;
  }

  std::string ContactConditions::worst() const
  {
    const auto figure = worst_figure();
    std::ostringstream out;
    out.precision(3);
    out << figure.first << " is " << figure.second;
    return out.str();
  }

  std::string ContactConditions::why_out_of_reach(const double tolerance) const
  {
    const auto figures = deciding_figures();
    if (rounding_ <= tolerance ||
        !std::all_of(figures.begin(), figures.end(), [&](const auto &figure) {
          return is_rounding(figure.second, rounding_);
        }))
      return {};
    if (rounding_ > largest_tolerance)
      return "all forces are no more than the rounding of what moves: there is "
             "nothing that double precision could certify";
    std::ostringstream out;
    out.precision(2);
    out << "double precision does not carry that far: where something moves by "
           "much more than it is strained, rounding alone makes about "
        << rounding_ << ", raise 'Contact solver/Tolerance' above both";
    return out.str();
  }
} // namespace stiction
