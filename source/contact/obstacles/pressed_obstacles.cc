#include <stiction/contact/obstacles/obstacle_motion.h>
#include <stiction/contact/obstacles/pressed_obstacles.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction
{
  namespace
  {
    // How far obstacle j has to go until it meets the node, were nothing to
    // move; infinite if it never does.
    double way_to(const Eigen::MatrixXd &directions, const Eigen::VectorXd &gaps,
                  const Eigen::Index node, const Eigen::Index j)
    {
      const double approach = -directions(node, j);
      return approach > least_approach ? gaps(node) / approach
                                       : std::numeric_limits<double>::infinity();
    }

    double shortest_way(const Eigen::MatrixXd &directions, const Eigen::VectorXd &gaps,
                        const Eigen::Index j)
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (Eigen::Index i = 0; i < directions.rows() / 3; ++i)
        shortest = std::min(shortest, way_to(directions, gaps, i, j));
      return shortest;
    }
  } // namespace

  ForceControl::Range range_of_search(const ObstacleMotion &motion,
                                      const Eigen::VectorXd &areas,
                                      const Eigen::VectorXd &forces,
                                      const double youngs_modulus, const double body_size)
  {
    const Eigen::MatrixXd &directions = motion.directions();
    const Eigen::VectorXd gaps        = motion.offset().head(areas.size());
    ForceControl::Range range;
    range.touch.resize(forces.size());
    range.reach.resize(forces.size());
    range.largest_reach = body_size;
    for (Eigen::Index j = 0; j < forces.size(); ++j)
      {
        range.touch(j)   = shortest_way(directions, gaps, j);
        const auto force = [&](const double depth) {
          double area = 0.;
          for (Eigen::Index i = 0; i < areas.size(); ++i)
            if (way_to(directions, gaps, i, j) <= range.touch(j) + depth)
              area += areas(i);
          return youngs_modulus * std::sqrt(area / (2. * M_PI)) * depth;
        };
        double low = 0., high = body_size;
        for (unsigned int k = 0; k < 60; ++k)
          {
            const double middle                      = 0.5 * (low + high);
            (force(middle) < forces(j) ? low : high) = middle;
          }
        range.reach(j) = high;
      }
    return range;
  }

  ForceControl::Outcome outcome_of(const Eigen::MatrixXd &directions,
                                   const Eigen::VectorXd &lambda,
                                   const Eigen::VectorXd &gradient,
                                   const double force_scale)
  {
    ForceControl::Outcome outcome;
    outcome.forces      = -directions.transpose() * lambda;
    outcome.force_scale = force_scale;
    outcome.clearance   = Eigen::VectorXd::Zero(directions.cols());

    for (Eigen::Index j = 0; j < directions.cols(); ++j)
      outcome.clearance(j) = std::max(shortest_way(directions, gradient, j), 0.);
    return outcome;
  }
} // namespace stiction
