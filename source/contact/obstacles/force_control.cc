#include <stiction/contact/obstacles/force_control.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stiction
{
  namespace
  {
    // A force below this part of the prescribed one is none.
    constexpr double no_force = 1e-9;

    // Between that of a flat punch, 1, and of a sphere, 1.5: with δ_t where
    // they touch, force ~ (δ − δ_t)^exponent, until there is a secant.
    constexpr double exponent = 1.25;

    // A force that goes with another power of the depth has a kink or a body
    // that gave way in between.
    constexpr double least_power = 0.3, largest_power = 5.;

    // An obstacle goes at most so many times as far beyond the place of first
    // contact as it has been.
    constexpr double largest_growth = 10.;

    constexpr unsigned int max_trials = 40; // for each obstacle

    // Forces tell how they change if they did by more than so many times their
    // noise.
    constexpr double telling_change = 10.;

    // Of several obstacles: what is left of the slope where a line ends.
    constexpr double required_fall_of_error = 0.7;

    // To tell how the forces change, the contact problem need only be solved
    // this much better than the last error of the forces.
    constexpr double accuracy_of_error = 1e-3;
  } // namespace

  ForceControl::ForceControl(Eigen::VectorXd prescribed, Range range)
    : prescribed_(std::move(prescribed))
    , range_(std::move(range))
    , first_reach_(range_.reach)
    , distances_(range_.touch + range_.reach)
  {
  }

  void ForceControl::begin_mesh()
  {
    last_.reset();
    before_last_.reset();
    too_near_   = infinity;
    too_far_    = -infinity;
    last_error_ = error_before_ = infinity;
  }

  std::string ForceControl::press(const Solve &solve, const double tolerance,
                                  const double finest_accuracy)
  {
    begin_mesh();
    double accuracy = std::max(accuracy_of_error, finest_accuracy);
    double share    = 1.; // of the smallest force in all
    for (unsigned int trials = 1; trials <= max_trials * prescribed_.size(); ++trials)
      {
        const double used     = share;
        const Outcome outcome = solve(used * accuracy);
        ++n_trials_;
        if (!outcome.reason.empty())
          return outcome.reason;
        if (!outcome.forces.allFinite())
          break;

        // beside the others the forces may have been rounding
        share = std::min(prescribed_.minCoeff() / outcome.force_scale, 1.);
        if (used > 10. * share)
          continue;
        // and where there is no other force, a little contact may have been
        // taken for none
        const bool is_blurred =
          (outcome.forces.array() <= 0. && outcome.clearance.array() <= 0.).any();
        if (is_blurred && accuracy > finest_accuracy)
          {
            accuracy = std::max(accuracy_of_error * accuracy, finest_accuracy);
            continue;
          }

        const double error = largest_relative_error(outcome.forces, prescribed_);
        if (error <= tolerance && accuracy <= finest_accuracy)
          return {};
        if (error > tolerance)
          {
            const std::string reason =
              advance(outcome, used * accuracy * outcome.force_scale);
            if (!reason.empty())
              return reason;
          }
        accuracy =
          std::max(std::min(accuracy, accuracy_of_error * error), finest_accuracy);
      }
    return "no place of the obstacle was found where it presses with its "
           "force, raise 'Contact solver/Tolerance' if the force is small "
           "beside the others";
  }

  std::string ForceControl::advance(const Outcome &outcome, const double noise)
  {
    const Eigen::VectorXd next      = place_after(outcome, noise);
    const Eigen::VectorXd new_reach = (next - range_.touch).cwiseAbs();
    if (new_reach.maxCoeff() > range_.largest_reach)
      return "an obstacle would have to move by more than the body is large to "
             "press with its force, lower 'Boundary conditions/Obstacle force' "
             "or hold the body better";
    range_.reach = range_.reach.cwiseMax(new_reach);
    distances_   = next;
    return {};
  }

  Eigen::VectorXd ForceControl::place_after(const Outcome &outcome, const double noise)
  {
    const Eigen::VectorXd &forces = outcome.forces;
    const bool is_one             = forces.size() == 1;
    const auto no_contact         = forces.array() <= no_force * prescribed_.array();
    if (no_contact.any() && (is_one || !last_))
      {
        // as far again beyond the place of contact
        const Eigen::VectorXd onwards =
          outcome.clearance +
          first_reach_.cwiseMax((distances_ - range_.touch).cwiseAbs());
        Eigen::VectorXd next =
          distances_ + Eigen::VectorXd(no_contact.cast<double>() * onwards.array());
        if (is_one)
          stay_within_interval(forces(0) - prescribed_(0), noise, next(0));
        return next;
      }
    if (!compliance_)
      compliance_ = first_compliance(forces);
    return is_one ? Eigen::VectorXd::Constant(1, place_of_one(forces(0), noise))
                  : places_of_several(forces, noise);
  }

  Eigen::MatrixXd ForceControl::first_compliance(const Eigen::VectorXd &forces) const
  {
    // the power law through the place of first contact and here
    Eigen::VectorXd compliance(forces.size());
    for (Eigen::Index j = 0; j < forces.size(); ++j)
      {
        const double depth =
          std::max(distances_(j) - range_.touch(j), 1e-3 * range_.reach(j));
        const double ratio = prescribed_(j) / forces(j);
        const double way   = depth * (std::pow(ratio, 1. / exponent) - 1.);
        compliance(j) = std::abs(ratio - 1.) > 1e-6 ? way / (prescribed_(j) - forces(j))
                                                    : depth / (exponent * forces(j));
      }
    return compliance.asDiagonal();
  }

  double ForceControl::place_of_one(const double force, const double noise)
  {
    const double missing = prescribed_(0) - force;
    if (last_ && std::abs(force - last_->forces(0)) > telling_change * noise)
      {
        (*compliance_)(0, 0) =
          (distances_(0) - last_->distances(0)) / (force - last_->forces(0));
        before_last_ = last_;
      }
    last_ = {distances_, Eigen::VectorXd::Constant(1, force)};

    double step =
      before_last_ ? interpolate() - distances_(0) : (*compliance_)(0, 0) * missing;
    // a force that no longer grows leaves the size of the step open
    const double limit = largest_growth * range_.reach(0);
    if (!std::isfinite(step) || step * missing <= 0.)
      step = missing > 0. ? limit : -limit;
    double next = distances_(0) + std::clamp(step, -limit, limit);
    stay_within_interval(-missing, noise, next);
    return next;
  }

  Eigen::VectorXd ForceControl::places_of_several(const Eigen::VectorXd &forces,
                                                  const double noise)
  {
    const Eigen::VectorXd error = forces - prescribed_;
    if (last_)
      {
        const double slope = error.dot(line_.direction);
        if (std::abs(slope) > -required_fall_of_error * line_.slope_at_start &&
            std::abs(slope) > telling_change * noise * line_.direction.cwiseAbs().sum())
          return last_->distances + line_.next(slope) * line_.direction;

        const Eigen::VectorXd step   = distances_ - last_->distances;
        const Eigen::VectorXd change = forces - last_->forces;
        const double curvature       = step.dot(change);
        if (curvature > 1e-12 * step.norm() * change.norm())
          {
            const auto n = step.size();
            const Eigen::MatrixXd projection =
              Eigen::MatrixXd::Identity(n, n) - step * change.transpose() / curvature;
            *compliance_ = projection * *compliance_ * projection.transpose() +
                           step * step.transpose() / curvature;
          }
      }
    last_                     = {distances_, forces};
    Eigen::VectorXd direction = -*compliance_ * error;
    const double length =
      direction.cwiseQuotient(largest_growth * range_.reach).cwiseAbs().maxCoeff();
    line_ = Line(direction / std::max(length, 1.), error);
    return distances_ + line_.direction;
  }

  ForceControl::Line::Line(Eigen::VectorXd along, const Eigen::VectorXd &error)
    : direction(std::move(along))
    , slope_at_start(error.dot(direction))
    , slope_below(slope_at_start)
  {
  }

  double ForceControl::Line::next(const double slope)
  {
    if (slope < 0.)
      {
        below       = at;
        slope_below = slope;
      }
    else
      {
        above       = at;
        slope_above = slope;
      }
    if (!std::isfinite(above))
      at *= 2.;
    else
      at = below + (above - below) *
                     std::clamp(slope_below / (slope_below - slope_above), 0.1, 0.9);
    return at;
  }

  double ForceControl::interpolate() const
  {
    const double x1 = before_last_->distances(0), x2 = last_->distances(0);
    const double f1 = before_last_->forces(0), f2 = last_->forces(0);
    const double depth1 = x1 - range_.touch(0), depth2 = x2 - range_.touch(0);
    const double slope = (f2 - f1) / (x2 - x1);
    if (depth1 > 0. && depth2 > 0.)
      {
        const double power = std::log(f2 / f1) / std::log(depth2 / depth1);
        if (power > least_power && power < largest_power)
          return range_.touch(0) + depth2 * std::pow(prescribed_(0) / f2, 1. / power);
      }
    return x2 + (prescribed_(0) - f2) / slope;
  }

  void ForceControl::stay_within_interval(const double error, const double noise,
                                          double &next)
  {
    if (error < -noise)
      too_far_ = std::max(too_far_, distances_(0));
    if (error > noise)
      too_near_ = std::min(too_near_, distances_(0));
    const bool is_slow =
      std::abs(error) > 0.5 * error_before_ && std::abs(error) > telling_change * noise;
    error_before_ = last_error_;
    last_error_   = std::abs(error);
    if (std::isfinite(too_far_) && std::isfinite(too_near_))
      {
        if (is_slow || !(next > too_far_ && next < too_near_))
          next = 0.5 * (too_far_ + too_near_);
      }
    else if (is_slow)
      next = distances_(0) + (error < 0. ? 1. : -1.) * largest_growth * range_.reach(0);
  }

  double largest_relative_error(const Eigen::VectorXd &forces,
                                const Eigen::VectorXd &prescribed)
  {
    return (forces - prescribed).cwiseQuotient(prescribed).cwiseAbs().maxCoeff();
  }
} // namespace stiction
