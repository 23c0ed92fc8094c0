#pragma once

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <array>
#include <optional>

namespace stiction
{
  /// As deal.II's points and normals are.
  inline Eigen::Vector3d to_vector(const dealii::Tensor<1, 3> &v)
  {
    return {v[0], v[1], v[2]};
  }

  inline dealii::Tensor<1, 3> to_tensor(const Eigen::Vector3d &v)
  {
    return dealii::Tensor<1, 3>({v(0), v(1), v(2)});
  }

  /// The frame of a contact node, and the two maps between Cartesian components
  /// and contact variables (ν; t1; t2) that go with it:
  ///
  ///     w = M u,   force on the obstacle = Mᵀ y,   M = diag(1, s1, s2)·(n; t1;
  ///     t2)
  ///
  /// so that y·w is the work of the force. Scales other than 1 turn the ellipse
  /// of orthotropic friction, (λ_1/F1)² + (λ_2/F2)² ≤ λ_ν², into the disc
  /// ‖y_t‖ ≤ F1 y_ν with s = (1, F2/F1), y_t = λ_t/s and w_t = s u_t: slip
  /// along the ellipse's normal is slip along y_t.
  ///
  /// A tangential direction in which the displacement is prescribed is held, s = 0: what
  /// happens there is the support's, w = 0 and y = 0; see
  /// ContactSurface::add_friction_on_supports(). A normal of which components are
  /// prescribed stays what it is: what is prescribed moves along it, and the support
  /// bears a part of the force. What is left to the body moves along the free normal: of
  /// such displacements M is diag(scales())·axes().
  struct ContactFrame
  {
    dealii::Tensor<1, 3> normal;           ///< n, unit, towards the obstacle
    dealii::Tensor<1, 3> tangent1;         ///< t1, unit
    dealii::Tensor<1, 3> tangent2;         ///< t2 = t1 × n
    std::array<double, 2> scale{{1., 1.}}; ///< s1, s2 ≥ 0; 0: held
    dealii::Tensor<1, 3>
      free_normal;         ///< n without what is prescribed, made a unit vector
    double free_part = 1.; ///< n times that, > 0
    /// Which Cartesian components of the displacement are prescribed.
    std::array<bool, 3> prescribed{{false, false, false}};
    /// Of the force, what acts at the node itself, > 0: the rest acts at nodes next to
    /// it, see ContactSurface::lend_areas(). No map of the frame has it.
    double own_part = 1.;

    /// Whether some displacement component is prescribed.
    bool is_held() const { return prescribed[0] || prescribed[1] || prescribed[2]; }

    /// (free n; t1; t2), orthonormal rows.
    Eigen::Matrix3d axes() const
    {
      Eigen::Matrix3d R;
      for (unsigned int c = 0; c < 3; ++c)
        {
          R(0, c) = free_normal[c];
          R(1, c) = tangent1[c];
          R(2, c) = tangent2[c];
        }
      return R;
    }

    /// What M makes of displacements along the axes: (free part of n, s1, s2).
    Eigen::Vector3d scales() const { return {free_part, scale[0], scale[1]}; }

    /// One over each, 0 where held.
    Eigen::Vector3d inverse_scales() const
    {
      return {1. / free_part, scale[0] > 0. ? 1. / scale[0] : 0.,
              scale[1] > 0. ? 1. / scale[1] : 0.};
    }

    /// w = M u.
    Eigen::Vector3d displacement_to_local(const Eigen::Vector3d &u) const
    {
      const dealii::Tensor<1, 3> x = to_tensor(u);
      return {normal * x, scale[0] * (tangent1 * x), scale[1] * (tangent2 * x)};
    }

    /// The u in the free directions of the frame with M u = w.
    Eigen::Vector3d displacement_to_cartesian(const Eigen::Vector3d &w) const
    {
      return combined(free_normal, w.cwiseProduct(inverse_scales()));
    }

    /// The y for a force: Mᵀ y is the same as that in the free directions.
    Eigen::Vector3d force_to_local(const Eigen::Vector3d &force) const
    {
      const dealii::Tensor<1, 3> x = to_tensor(force);
      return Eigen::Vector3d(free_normal * x, tangent1 * x, tangent2 * x)
        .cwiseProduct(inverse_scales());
    }

    /// Mᵀ y.
    Eigen::Vector3d force_to_cartesian(const Eigen::Vector3d &y) const
    {
      return combined(normal, {y(0), scale[0] * y(1), scale[1] * y(2)});
    }

    /// Without the components that are prescribed.
    Eigen::Vector3d in_free_directions(Eigen::Vector3d v) const
    {
      for (unsigned int c = 0; c < 3; ++c)
        if (prescribed[c])
          v(c) = 0.;
      return v;
    }

  private:
    Eigen::Vector3d combined(const dealii::Tensor<1, 3> &first,
                             const Eigen::Vector3d &amounts) const
    {
      const dealii::Tensor<1, 3> x =
        amounts(0) * first + amounts(1) * tangent1 + amounts(2) * tangent2;
      return {x[0], x[1], x[2]};
    }
  };

  /// Makes the frame of a unit normal: t1 the normalised tangential part of e_x
  /// (of e_y if |n_x| > 0.9), t2 = t1 × n, no scales.
  ///
  /// Where displacement components are prescribed, the free normal loses these, a
  /// prescribed direction becomes t1 (two of them t1 and t2 = t1 × free n) and is held.
  ///
  /// @return whether it can be in contact: at least 1e-3 of the normal is free.
  ///   If not, the frame is as it was.
  bool set_tangents(ContactFrame &frame);

  /// Gives a frame made by set_tangents() its ellipse of friction with the
  /// semi-axes @p first, @p second along the principal directions: the
  /// tangential part of @p direction (without: t1), and that × n. Both are > 0
  /// or both 0. Sets t1, t2 and the scales; where a direction is held, only the
  /// ellipse's extent along the free one counts, g/√(t·Dt).
  ///
  /// @return the radius of the disc that the ellipse becomes; nothing if the
  ///   direction has no tangential part.
  std::optional<double> set_friction_ellipse(
    ContactFrame &frame, double first, double second,
    const std::optional<dealii::Tensor<1, 3>> &direction = std::nullopt);
} // namespace stiction
