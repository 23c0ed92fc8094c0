#include <stiction/contact/obstacles/obstacle_motion.h>
#include <stiction/contact/obstacles/pressed_obstacles.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stiction
{
  Eigen::VectorXd ways_to_press(const ObstacleMotion &motion, const Eigen::VectorXd &gaps,
                                const Eigen::VectorXd &areas, const double youngs_modulus)
  {
    Eigen::VectorXd ways = Eigen::VectorXd::Zero(motion.n_pressed());
    for (Eigen::Index j = 0; j < ways.size(); ++j)
      {
        // the nodes as they are met, with their areas
        std::vector<std::pair<double, double>> met;
        for (Eigen::Index i = 0; i < areas.size(); ++i)
          if (-motion.directions()(i, j) > least_approach)
            met.emplace_back(-gaps(i) / motion.directions()(i, j), areas(i));
        std::sort(met.begin(), met.end());

        // the force jumps where a node is met and grows in proportion in between
        double area = 0.;
        for (std::size_t k = 0; k < met.size(); ++k)
          {
            area += met[k].second;
            const double depth =
              motion.forces()(j) / (youngs_modulus * std::sqrt(area / (2. * M_PI)));
            ways(j) = std::max(met[k].first, met.front().first + depth);
            if (k + 1 < met.size() && ways(j) <= met[k + 1].first)
              break;
          }
      }
    return ways;
  }

  Eigen::MatrixXd uniform_pressures(const ObstacleMotion &motion,
                                    const Eigen::VectorXd &areas)
  {
    const Eigen::Index m   = areas.size();
    Eigen::MatrixXd lambda = Eigen::MatrixXd::Zero(3 * m, motion.n_pressed());
    for (Eigen::Index j = 0; j < motion.n_pressed(); ++j)
      {
        const Eigen::VectorXd approach = -motion.directions().col(j).head(m);
        const Eigen::VectorXd met = (approach.array() > least_approach).select(areas, 0.);
        lambda.col(j).head(m)     = motion.forces()(j) / met.dot(approach) * met;
      }
    return lambda;
  }
} // namespace stiction
