#include <stiction/contact/contact_surface.h>
#include <stiction/contact/force_control.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    // A force below this part of the prescribed one is none.
    constexpr double no_force = 1e-9;

    // Between that of a flat punch, 1, and of a sphere, 1.5: with δ_t where
    // they touch, force ~ (δ − δ_t)^exponent, until there is a secant.
    constexpr double exponent = 1.25;

    // An obstacle goes at most so many times as far beyond the place of first
    // contact as it has been.
    constexpr double largest_growth = 3.;

    constexpr unsigned int max_trials = 40;

    // A direction approaches a node if its cosine with −n is above this one.
    constexpr double approaching_cosine = 0.1;

    // How far obstacle j has to go until it meets the node, were nothing to
    // move; infinite if it never does.
    double
    way_to(const Eigen::MatrixXd &directions,
           const Eigen::VectorXd &gaps,
           const Eigen::Index node,
           const Eigen::Index j)
    {
      const double approach = -directions(node, j);
      return approach > approaching_cosine
               ? gaps(node) / approach
               : std::numeric_limits<double>::infinity();
    }

    double
    shortest_way(const Eigen::MatrixXd &directions,
                 const Eigen::VectorXd &gaps,
                 const Eigen::Index j)
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (Eigen::Index i = 0; i < directions.rows() / 3; ++i)
        shortest = std::min(shortest, way_to(directions, gaps, i, j));
      return shortest;
    }
  } // namespace



  ForceControl::ForceControl(const ContactSurface &surface,
                             const double youngs_modulus)
    : prescribed_(surface.pressing_forces())
    , size_(std::sqrt(surface.boundary_area()))
    , distances_(prescribed_.size())
    , touch_(prescribed_.size())
    , reach_(prescribed_.size())
  {
    const Eigen::MatrixXd &directions = surface.motion().directions();
    const Eigen::VectorXd gaps        = surface.gaps();
    for (Eigen::Index j = 0; j < prescribed_.size(); ++j)
      {
        touch_(j) = shortest_way(directions, gaps, j);
        // E √(A/π) δ, with half the area that is cut for the one in contact
        const auto guess = [&](const double depth) {
          double area = 0.;
          for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
            if (way_to(directions, gaps, i, j) <= touch_(j) + depth)
              area += surface.areas()(i);
          return youngs_modulus * std::sqrt(area / (2. * M_PI)) * depth;
        };
        double low = 0., high = size_;
        for (unsigned int k = 0; k < 60; ++k)
          {
            const double middle                           = 0.5 * (low + high);
            (guess(middle) < prescribed_(j) ? low : high) = middle;
          }
        reach_(j)     = high;
        distances_(j) = touch_(j) + reach_(j);
      }
  }



  void
  ForceControl::begin_mesh()
  {
    last_.reset();
    too_near_         = infinity;
    too_far_          = -infinity;
    n_on_one_side_    = 0;
    n_trials_on_mesh_ = 0;
  }



  bool
  ForceControl::advance(const Outcome &outcome, const double tolerance)
  {
    ++n_trials_;
    if (((outcome.forces - prescribed_).array().abs() <= tolerance).all())
      return false;
    if (!outcome.forces.allFinite() || ++n_trials_on_mesh_ == max_trials)
      {
        reason_ = "no place of the obstacle was found where it presses with "
                  "its force, check 'Boundary conditions/Obstacle force'";
        return false;
      }

    learn(outcome.forces);
    Eigen::VectorXd next = distances_ + next_step(outcome);
    if (next.size() == 1)
      stay_within_interval(outcome.forces(0), next(0));
    reach_     = reach_.cwiseMax((next - touch_).cwiseAbs());
    distances_ = next;
    if (reach_.maxCoeff() <= size_)
      return true;
    reason_ = "an obstacle would have to move by more than the contact "
              "boundary is large to press with its force, lower 'Boundary "
              "conditions/Obstacle force' or hold the body better";
    return false;
  }



  void
  ForceControl::learn(const Eigen::VectorXd &forces)
  {
    const auto in_contact = forces.array() > no_force * prescribed_.array();
    if (!in_contact.all())
      {
        last_.reset();
        return;
      }
    if (last_)
      {
        const Eigen::VectorXd step   = distances_ - last_->distances;
        const Eigen::VectorXd change = forces - last_->forces;
        *slope_ +=
          (change - *slope_ * step) * step.transpose() / step.squaredNorm();
      }
    else if (!slope_)
      {
        // the power law through the place of first contact and here
        Eigen::VectorXd slope(forces.size());
        for (Eigen::Index j = 0; j < forces.size(); ++j)
          {
            const double depth =
              std::max(distances_(j) - touch_(j), 1e-3 * reach_(j));
            const double ratio = prescribed_(j) / forces(j);
            const double way   = depth * (std::pow(ratio, 1. / exponent) - 1.);
            slope(j)           = std::abs(ratio - 1.) > 1e-6
                                   ? (prescribed_(j) - forces(j)) / way
                                   : exponent * forces(j) / depth;
          }
        slope_ = Eigen::MatrixXd(slope.asDiagonal());
      }
    last_ = {distances_, forces};
  }



  Eigen::VectorXd
  ForceControl::next_step(const Outcome &outcome) const
  {
    const Eigen::VectorXd missing = prescribed_ - outcome.forces;
    Eigen::VectorXd step          = Eigen::VectorXd::Zero(missing.size());
    if (last_)
      step = slope_->partialPivLu().solve(missing);
    for (Eigen::Index j = 0; j < step.size(); ++j)
      if (outcome.forces(j) <= no_force * prescribed_(j))
        step(j) = outcome.clearance(j) + reach_(j);
      else
        {
          // a force that no longer grows leaves the size of the step open
          const double limit = largest_growth * reach_(j);
          if (!std::isfinite(step(j)) ||
              (step.size() == 1 && step(j) * missing(j) <= 0.))
            step(j) = missing(j) > 0. ? limit : -limit;
          step(j) = std::clamp(step(j), -limit, limit);
        }
    return step;
  }



  void
  ForceControl::stay_within_interval(const double force, double &next)
  {
    // far: not near enough to press as it should
    const bool is_far = force < prescribed_(0);
    double &end       = is_far ? too_far_ : too_near_;
    n_on_one_side_    = (is_far ? distances_(0) > end : distances_(0) < end)
                          ? n_on_one_side_ + 1
                          : 1;
    end               = distances_(0);
    if (!std::isfinite(too_far_) || !std::isfinite(too_near_))
      return;
    const bool is_slow = n_on_one_side_ > 3;
    if (is_slow || !(next > too_far_ && next < too_near_))
      {
        next           = 0.5 * (too_far_ + too_near_);
        n_on_one_side_ = 0;
      }
  }



  ForceControl::Outcome
  outcome_of(const Eigen::MatrixXd &directions,
             const Eigen::VectorXd &lambda,
             const Eigen::VectorXd &gradient)
  {
    ForceControl::Outcome outcome;
    outcome.forces    = -directions.transpose() * lambda;
    outcome.clearance = Eigen::VectorXd::Zero(directions.cols());
    for (Eigen::Index j = 0; j < directions.cols(); ++j)
      outcome.clearance(j) =
        std::max(shortest_way(directions, gradient, j), 0.);
    return outcome;
  }
} // namespace stiction
