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
} // namespace stiction
