#pragma once

#include <Eigen/Core>

#include <vector>

namespace stiction::qp
{
  class SlipBound;

  /// The contact and friction conditions linearised at a point: which
  /// components of the step are prescribed, which are free, and the
  /// stiffness the curvature of the circles adds to the free ones.
  ///
  /// The step is d = d0 + Z y. With given friction the reduced equation is
  /// (ZᵀQZ + diag μ) y = −Zᵀ(r + Q d0); with Coulomb friction the rows are
  /// tested with W instead, Z without the part of the tangential force that
  /// follows the normal one.
  class ContactLinearization
  {
  public:
    /// @param x, gradient the point and r = Qx − h there, entries (ν; t1; t2),
    ///   or (t1; t2) only where the normal forces are held fixed.
    /// @param rho length m, > 0, unit N/m.
    ContactLinearization(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                         const Eigen::VectorXd &rho, const SlipBound &slip_bound);

    /// Number of free components, the length of y.
    Eigen::Index n_free() const { return static_cast<Eigen::Index>(free_.size()); }

    /// d0, the length of x.
    const Eigen::VectorXd &prescribed() const { return prescribed_; }

    /// μ ≥ 0, length n_free(), unit m/N.
    const Eigen::VectorXd &curvature() const { return curvature_; }

    /// Z y, the length of x.
    Eigen::VectorXd embed(const Eigen::VectorXd &y) const;

    /// Wᵀ v, length n_free().
    Eigen::VectorXd test(const Eigen::VectorXd &v) const;

    /// Zᵀ v, length n_free().
    Eigen::VectorXd transpose_embed(const Eigen::VectorXd &v) const;

    /// The node of each free component.
    Eigen::Index node(const Eigen::Index k) const { return free_[k].node; }

    /// ‖x − P(x − ρr)‖ with the slip bound at x − ρr: zero at solutions only.
    double residual() const { return residual_; }

  private:
    /// A free component: a direction in the three components of one node.
    struct Free
    {
      Eigen::Index node;
      Eigen::Vector3d direction; ///< of the test space
      Eigen::Vector2d follows;   ///< tangential force per normal force
    };

    Eigen::Index m_;
    bool has_normal_;
    Eigen::Index t1_, t2_; ///< where the tangential blocks begin
    std::vector<Free> free_;
    Eigen::VectorXd prescribed_, curvature_;
    double residual_ = 0.;
  };
} // namespace stiction::qp
