#include <stiction/contact/interface/contact_frame.h>

#include <cmath>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // What has to be left of a normal without its prescribed components.
    constexpr double least_normal = 1e-3;

    // ... and of a direction without its normal component.
    constexpr double least_tangent = 1e-6;

    Tensor<1, 3> first_tangent(const Tensor<1, 3> &normal)
    {
      Tensor<1, 3> e;
      e[std::abs(normal[0]) > 0.9 ? 1 : 0] = 1.;
      Tensor<1, 3> tangent                 = e - (e * normal) * normal;
      tangent /= tangent.norm();
      return tangent;
    }
  } // namespace

  bool set_tangents(ContactFrame &frame)
  {
    Tensor<1, 3> free = frame.normal;
    Tensor<1, 3> held;
    unsigned int n_held = 0;
    for (unsigned int c = 0; c < 3; ++c)
      if (frame.prescribed[c])
        {
          free[c] = 0.;
          if (n_held == 0)
            held[c] = 1.;
          ++n_held;
        }
    const double part = free.norm();
    if (part < least_normal)
      return false;

    frame.free_part   = n_held > 0 ? part : 1.;
    frame.free_normal = free / frame.free_part;
    frame.tangent1    = n_held > 0 ? held : first_tangent(frame.normal);
    frame.tangent2    = cross_product_3d(frame.tangent1, frame.free_normal);
    frame.scale       = {{n_held > 0 ? 0. : 1., n_held > 1 ? 0. : 1.}};
    return true;
  }

  std::optional<double> set_friction_ellipse(ContactFrame &frame, const double first,
                                             const double second,
                                             const std::optional<Tensor<1, 3>> &direction)
  {
    Tensor<1, 3> principal = first_tangent(frame.normal);
    if (direction)
      {
        principal = *direction - (*direction * frame.normal) * frame.normal;
        if (!(principal.norm() > least_tangent * direction->norm()))
          return std::nullopt;
        principal /= principal.norm();
      }
    const bool is_disc = first == second;
    if (frame.scale[0] == 0.)
      {
        // one number is left of the ellipse, or none that matters
        if (is_disc || frame.scale[1] == 0.)
          return first;
        const Tensor<1, 3> other = cross_product_3d(principal, frame.normal);
        return 1. / std::hypot(frame.tangent2 * principal / first,
                               frame.tangent2 * other / second);
      }
    frame.tangent1 = principal;
    frame.tangent2 = cross_product_3d(frame.tangent1, frame.normal);
    frame.scale    = {{1., is_disc ? 1. : second / first}};
    return first;
  }
} // namespace stiction
