#include <stiction/contact/primal/foundation.h>
#include <stiction/elasticity/mesh/body.h>

namespace stiction
{
  Eigen::VectorXd foundation_under(const Eigen::VectorXd &youngs_moduli,
                                   const Eigen::VectorXd &areas, const Body &body)
  {
    const auto corners = body.bounding_box().get_boundary_points();
    return youngs_moduli.cwiseProduct(areas) / corners.first.distance(corners.second);
  }
} // namespace stiction
