#include <stiction/qp/contact_scales.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    // Of how far a pressure S/|Γc| presses in a half-space: a body that gives way by less
    // is as it is made, and its energy rounding.
    constexpr double undeformed = 1e-8;
  } // namespace

  qp::Scaling contact_scaling(const double S, const double energy,
                              const Eigen::VectorXd &areas, const double boundary_area,
                              const ContactStiffness &stiffness)
  {
    const double p0 = S / boundary_area;
    qp::Scaling scaling;
    scaling.force        = areas * p0;
    const double least   = undeformed * p0 * std::sqrt(boundary_area) / stiffness.softest;
    scaling.displacement = energy > 0. ? std::max(energy / S, least) : 1.;

    const Eigen::VectorXd &E = stiffness.youngs_moduli;
    if ((E.array() <= stiffness.softest).all())
      return scaling;
    // of a half-space that p0 presses in by u0
    const double modulus = p0 * std::sqrt(boundary_area) / scaling.displacement;
    scaling.weight = (std::max(stiffness.softest, modulus) / E.array()).cwiseMin(1.);
    return scaling;
  }
} // namespace stiction
