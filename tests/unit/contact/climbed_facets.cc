// The energy of facets that were climbed: a round surface, a plane and a taper have none
// however they slide, and neither have facets along which nothing slides; of a ring of
// teeth that was turned it is half of what each force did on its way up.

#include <stiction/contact/pairs/climbed_facets.h>

#include <Eigen/Geometry>

#include <cmath>
#include <iostream>

using namespace stiction;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixX3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
  constexpr Index n = 24;

  // Points of a cone with this slope around z, radius 1 at z = 0, whose normals point
  // inwards and are turned by an angle, every second one the other way.
  struct Ring
  {
    explicit Ring(const double slope, const double angle = 0.)
      : positions(n, 3)
      , normals(n, 3)
      , areas(VectorXd::Constant(n, 0.1))
      , forces(n)
    {
      for (Index i = 0; i < n; ++i)
        {
          const double a = 4. * std::acos(0.) * i / n, z = 0.1 * (i % 3);
          const Vector3d outwards(std::cos(a), std::sin(a), 0.);
          positions.row(i)      = (1. + slope * z) * outwards + z * Vector3d::UnitZ();
          const Vector3d normal = (slope * Vector3d::UnitZ() - outwards).normalized();
          normals.row(i) =
            Eigen::AngleAxisd(i % 2 == 0 ? angle : -angle, Vector3d::UnitZ()) * normal;
          forces(i) = i % 2 == 0 ? 3. : 1.;
        }
    }

    double climbed(const Vector3d &way, const Vector3d &turn) const
    {
      MatrixX3d slip(n, 3);
      for (Index i = 0; i < n; ++i)
        slip.row(i) = way + turn.cross(positions.row(i).transpose());
      return climbed_facets(positions, normals, slip, areas, forces);
    }

    MatrixX3d positions, normals;
    VectorXd areas, forces;
  };

  void print(const char *const what, const double energy, const double exact)
  {
    std::cout << what << ": " << (std::abs(energy - exact) < 1e-12 ? "right" : "wrong")
              << std::endl;
  }
} // namespace

int main()
{
  const Vector3d none = Vector3d::Zero(), z = Vector3d::UnitZ();
  print("cylinder, along and about its axis", Ring(0.).climbed(z, 0.3 * z), 0.);
  print("taper of 1 degree, along and about its axis", Ring(0.0175).climbed(z, 0.3 * z),
        0.);

  Ring plane(0.);
  plane.positions.col(2).setZero();
  plane.normals.rowwise() = z.transpose();
  print("plane", plane.climbed(Vector3d::UnitX(), 0.3 * z), 0.);

  // Up by sin(angle) at one half of the nodes and down by as much at the other half, with
  // radii of 1. The motion is about the axis alone, along which facets rise least.
  constexpr double angle = 0.02, turn = 0.01;
  const Ring teeth(0., angle);
  const double exact = 0.5 * turn * std::sin(angle) * (3. - 1.) * n / 2.;
  print("teeth, turned up", teeth.climbed(none, -turn * z), exact);
  print("teeth, turned down", teeth.climbed(none, turn * z), -exact);
  print("teeth, not turned", teeth.climbed(none, none), 0.);
  print("teeth too steep for facets", Ring(0., 0.1).climbed(none, turn * z), 0.);
}
