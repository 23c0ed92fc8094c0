// The frame of a contact node: its maps are inverse to each other and keep
// work; they turn an ellipse of friction into a disc and its normals into the
// disc's; directions that are held drop out, with the ellipse cut along the
// free one.

#include "tests.h"

#include <stiction/contact/interface/contact_frame.h>

#include <cmath>
#include <optional>

using namespace stiction;
using dealii::Tensor;

namespace
{
  Eigen::Vector3d eigen(const Tensor<1, 3> &v) { return {v[0], v[1], v[2]}; }

  ContactFrame frame_of(const Tensor<1, 3> &normal,
                        const std::array<bool, 3> &prescribed = {{false, false, false}})
  {
    ContactFrame frame;
    frame.normal     = normal / normal.norm();
    frame.prescribed = prescribed;
    set_tangents(frame);
    return frame;
  }

  const char *is_orthonormal(const ContactFrame &frame)
  {
    const Eigen::Matrix3d R = frame.axes();
    return yes(
      (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-14 &&
      (cross_product_3d(frame.tangent1, frame.free_normal) - frame.tangent2).norm() <
        1e-14);
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Tensor<1, 3> slanted({0.6, -0.3, -0.8}), down({0., 0., -1.});
  const Eigen::Vector3d u(0.3, -1.2, 0.7), y(2., 0.4, -0.9);
  {
    ContactFrame frame = frame_of(slanted);
    const auto radius = set_friction_ellipse(frame, 0.5, 0.2, Tensor<1, 3>({1., 2., 3.}));
    const Eigen::Vector3d w     = frame.displacement_to_local(u);
    const Eigen::Vector3d force = frame.force_to_cartesian(y);
    std::cout << "ellipse: orthonormal " << is_orthonormal(frame)
              << ", t1 in the plane of direction and normal "
              << yes(std::abs(cross_product_3d(Tensor<1, 3>({1., 2., 3.}), frame.normal) *
                              frame.tangent1) < 1e-14)
              << ", displacement there and back "
              << yes(frame.displacement_to_cartesian(w).isApprox(u, 1e-14))
              << ", force there and back "
              << yes(frame.force_to_local(force).isApprox(y, 1e-14)) << ", the same work "
              << yes(std::abs(y.dot(w) - force.dot(u)) < 1e-14) << std::endl;

    // a force on the ellipse, with λ_ν = 1, and a slip along its normal
    const double phi = 0.7;
    const Eigen::Vector3d on_ellipse =
      eigen(frame.normal + 0.5 * std::cos(phi) * frame.tangent1 +
            0.2 * std::sin(phi) * frame.tangent2);
    const Eigen::Vector3d along_normal =
      eigen(std::cos(phi) / 0.5 * frame.tangent1 + std::sin(phi) / 0.2 * frame.tangent2);
    const Eigen::Vector3d disc = frame.force_to_local(on_ellipse);
    const Eigen::Vector3d slip = frame.displacement_to_local(along_normal);
    std::cout << "radius " << *radius << ", forces on the ellipse are on the "
              << "disc " << yes(std::abs(disc.tail<2>().norm() - 0.5) < 1e-14)
              << ", its normals are radii "
              << yes(std::abs(disc(1) * slip(2) - disc(2) * slip(1)) < 1e-14 &&
                     disc.dot(slip) > 0.)
              << std::endl;
  }
  {
    ContactFrame disc = frame_of(slanted), zero = disc, none = disc;
    const Tensor<1, 3> t1 = disc.tangent1;
    std::cout << "equal axes: no scales "
              << yes(*set_friction_ellipse(disc, 0.3, 0.3) == 0.3 &&
                     disc.scales() == Eigen::Vector3d(1., 1., 1.) && disc.tangent1 == t1)
              << ", without friction neither "
              << yes(*set_friction_ellipse(zero, 0., 0.) == 0. &&
                     zero.scales() == Eigen::Vector3d(1., 1., 1.))
              << ", a direction along the normal is none "
              << yes(!set_friction_ellipse(none, 0.3, 0.1, -2. * none.normal))
              << std::endl;
  }
  for (const std::array<bool, 3> &prescribed : {std::array<bool, 3>{{true, false, false}},
                                                std::array<bool, 3>{{false, true, false}},
                                                std::array<bool, 3>{{true, true, false}},
                                                std::array<bool, 3>{{false, true, true}}})
    {
      ContactFrame frame = frame_of(slanted, prescribed);
      const auto again   = frame;
      set_tangents(frame);
      // The sets of λ_t in the tangent plane, cut along the free direction.
      const auto radius =
        set_friction_ellipse(frame, 0.5, 0.2, Tensor<1, 3>({1., 2., 3.}));
      ContactFrame whole = frame_of(frame.normal);
      const auto first =
        set_friction_ellipse(whole, 0.5, 0.2, Tensor<1, 3>({1., 2., 3.}));
      const Eigen::Vector3d t = eigen(frame.tangent2);
      const double cut        = *first / whole.force_to_local(t).tail<2>().norm();
      const bool one          = frame.scale[1] > 0.;

      const Eigen::Vector3d force = frame.force_to_cartesian(y);
      const Eigen::Vector3d w     = frame.displacement_to_local(u);
      const Eigen::Vector3d back  = frame.displacement_to_cartesian(w);
      const Eigen::Vector3d free =
        (frame.scales().array() > 0.).matrix().cast<double>().asDiagonal() * w;
      std::cout << "prescribed " << prescribed[0] << prescribed[1] << prescribed[2]
                << ": orthonormal " << is_orthonormal(frame) << ", made twice the same "
                << yes((again.axes() - frame.axes()).norm() < 1e-15) << ", held "
                << (frame.scale[0] == 0.) << (frame.scale[1] == 0.)
                << ", all of the normal force "
                << yes(std::abs(force.dot(eigen(frame.normal)) - y(0)) < 1e-14)
                << ", what is prescribed moves along the normal "
                << yes(std::abs(w(0) - eigen(frame.normal).dot(u)) < 1e-14)
                << ", the same work " << yes(std::abs(y.dot(w) - force.dot(u)) < 1e-14)
                << ", there and back in free directions "
                << yes(back == frame.in_free_directions(back) &&
                       frame.displacement_to_local(back).isApprox(free, 1e-14))
                << ", no force without work "
                << yes(frame.force_to_local(force).isApprox(
                     y.cwiseProduct(
                       (frame.scales().array() > 0.).matrix().cast<double>()),
                     1e-14))
                << ", bound is the ellipse's there "
                << yes(!one || std::abs(*radius - cut) < 1e-14) << std::endl;
    }
  ContactFrame all = frame_of(down), normal = all;
  all.prescribed    = {{true, true, true}};
  normal.prescribed = {{false, false, true}};
  std::cout << "held altogether: no contact " << yes(!set_tangents(all))
            << ", held along the normal: no contact " << yes(!set_tangents(normal))
            << std::endl;
}
