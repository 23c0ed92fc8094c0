#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/rigid_body_modes.h>

namespace stiction
{
  using namespace dealii;

  std::vector<std::vector<double>> rigid_body_modes(
    const Body &body, const std::vector<Point<3>> &positions)
  {
    const Point<3> centre = body.bounding_box().center();
    const double radius   = body.diameter() / 2.;

    std::vector<std::vector<double>> modes(6, std::vector<double>(3 * positions.size()));
    for (std::size_t i = 0; i < positions.size(); ++i)
      {
        const Tensor<1, 3> x = (positions[i] - centre) / radius;
        for (unsigned int a = 0; a < 3; ++a)
          {
            modes[a][3 * i + a] = 1.;
            // e_a × x is -x_{a+2} along a+1 and x_{a+1} along a+2
            modes[3 + a][3 * i + (a + 1) % 3] = -x[(a + 2) % 3];
            modes[3 + a][3 * i + (a + 2) % 3] = x[(a + 1) % 3];
          }
      }
    return modes;
  }
} // namespace stiction
