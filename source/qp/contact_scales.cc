#include <stiction/qp/contact_scales.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  qp::Scaling contact_scaling(const double S, const double energy,
                              const Eigen::VectorXd &areas, const double boundary_area,
                              const ContactStiffness &stiffness)
  {
    const double p0 = S / boundary_area;
    qp::Scaling scaling;
    scaling.force        = areas * p0;
    scaling.displacement = nonzero(std::max(energy, 0.) / S);

    const Eigen::VectorXd &E = stiffness.youngs_moduli;
    if ((E.array() <= stiffness.softest).all())
      return scaling;
    // of a half-space that p0 presses in by u0
    const double modulus = p0 * std::sqrt(boundary_area) / scaling.displacement;
    scaling.weight = (std::max(stiffness.softest, modulus) / E.array()).cwiseMin(1.);
    return scaling;
  }
} // namespace stiction
