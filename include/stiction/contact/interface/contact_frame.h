#ifndef stiction_contact_interface_contact_frame_h
#define stiction_contact_interface_contact_frame_h

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <array>
#include <optional>

namespace stiction
{
  /// As deal.II's points and normals are.
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
  /// A direction in which the displacement is prescribed is held, s = 0: what happens
  /// there is the support's, w = 0 and y = 0; see
  /// ContactSurface::add_friction_on_supports().
  struct ContactFrame
  {
    dealii::Tensor<1, 3> normal;           ///< n, unit, towards the obstacle
    dealii::Tensor<1, 3> tangent1;         ///< t1, unit
    dealii::Tensor<1, 3> tangent2;         ///< t2 = t1 × n
    std::array<double, 2> scale{{1., 1.}}; ///< s1, s2 ≥ 0; 0: held
    /// By how much the gap grows with displacements of the other side: n, and where a
    /// part of n is held, n over its cosine with what is left.
    dealii::Tensor<1, 3> gap_growth;
    /// Which Cartesian components of the displacement are prescribed.
    std::array<bool, 3> prescribed{{false, false, false}};

    /// Whether some displacement component is prescribed.
    bool is_held() const { return prescribed[0] || prescribed[1] || prescribed[2]; }

    /// (n; t1; t2), orthonormal rows.
    Eigen::Matrix3d axes() const
    {
      Eigen::Matrix3d R;
      for (unsigned int c = 0; c < 3; ++c)
        {
          R(0, c) = normal[c];
          R(1, c) = tangent1[c];
          R(2, c) = tangent2[c];
        }
      return R;
    }

    /// (1, s1, s2).
    Eigen::Vector3d scales() const { return {1., scale[0], scale[1]}; }

    /// (1, 1/s1, 1/s2), 0 where held.
    Eigen::Vector3d inverse_scales() const
    {
      return {1., scale[0] > 0. ? 1. / scale[0] : 0., scale[1] > 0. ? 1. / scale[1] : 0.};
    }

    /// w = M u.
    Eigen::Vector3d displacement_to_local(const Eigen::Vector3d &u) const
    {
      return rotate(u).cwiseProduct(scales());
    }

    /// What a displacement U of the other side is to the node, (gap_growth·U; s1 t1·U;
    /// s2 t2·U), so that w of the node relative to it is M u less that.
    Eigen::Vector3d other_side_to_local(const Eigen::Vector3d &U) const
    {
      Eigen::Vector3d local = displacement_to_local(U);
      local(0) = gap_growth[0] * U(0) + gap_growth[1] * U(1) + gap_growth[2] * U(2);
      return local;
    }

    /// The force on the other side that does the same work there as y here.
    Eigen::Vector3d force_on_other_side(const Eigen::Vector3d &y) const
    {
      return force_to_cartesian({0., y(1), y(2)}) +
             y(0) * Eigen::Vector3d(gap_growth[0], gap_growth[1], gap_growth[2]);
    }

    /// The u in the free directions of the frame with M u = w.
    Eigen::Vector3d displacement_to_cartesian(const Eigen::Vector3d &w) const
    {
      return rotate_back(w.cwiseProduct(inverse_scales()));
    }

    /// The y for a force: Mᵀ y is its part in the free directions.
    Eigen::Vector3d force_to_local(const Eigen::Vector3d &force) const
    {
      return rotate(force).cwiseProduct(inverse_scales());
    }

    /// Mᵀ y.
    Eigen::Vector3d force_to_cartesian(const Eigen::Vector3d &y) const
    {
      return rotate_back(y.cwiseProduct(scales()));
    }

  private:
    Eigen::Vector3d rotate(const Eigen::Vector3d &v) const
    {
      const dealii::Tensor<1, 3> x = to_tensor(v);
      return {normal * x, tangent1 * x, tangent2 * x};
    }

    Eigen::Vector3d rotate_back(const Eigen::Vector3d &v) const
    {
      const dealii::Tensor<1, 3> x = v(0) * normal + v(1) * tangent1 + v(2) * tangent2;
      return {x[0], x[1], x[2]};
    }
  };

  /// Makes the frame of a unit normal: t1 the normalised tangential part of e_x
  /// (of e_y if |n_x| > 0.9), t2 = t1 × n, no scales.
  ///
  /// Where displacement components are prescribed, it lies in what is free: the
  /// normal loses these components, a prescribed direction becomes t1 (two of
  /// them t1 and t2) and is held. Calling it again does no harm.
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

#endif
