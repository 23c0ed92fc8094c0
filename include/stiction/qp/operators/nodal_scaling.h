#ifndef stiction_qp_operators_nodal_scaling_h
#define stiction_qp_operators_nodal_scaling_h

#include <Eigen/Core>

namespace stiction::qp
{
  struct Scaling;

  /// The change of variables x = D y with one scale d_i > 0 a node, the same
  /// for all components of a node, so that discs stay discs and projections
  /// stay what they are.
  ///
  /// In y the Hessian is D A D (ScaledOperator), the gradient D r, a radius
  /// g_i becomes g_i/d_i, and a residual measured with scaled() is the one of
  /// x. Vectors may have any number of blocks of n_nodes() entries.
  class NodalScaling
  {
  public:
    /// Throws std::invalid_argument if a scale is not positive and finite.
    explicit NodalScaling(Eigen::VectorXd scales);

    /// d_i = 1/√(mean diagonal entry of node i): D A D then has a mean
    /// diagonal entry of 1 at each node. Throws std::invalid_argument if a
    /// mean is not positive and finite.
    ///
    /// @param diagonal the diagonal of A, in blocks of @p n_nodes entries
    static NodalScaling from_diagonal(const Eigen::VectorXd &diagonal,
                                      Eigen::Index n_nodes);

    Eigen::Index n_nodes() const { return scales_.size(); }

    /// d, length n_nodes().
    const Eigen::VectorXd &scales() const { return scales_; }

    /// D v: a point from y to x, a gradient from x to y.
    Eigen::VectorXd times(const Eigen::VectorXd &v) const;

    /// D⁻¹ v: a point and radii from x to y, a gradient from y to x.
    Eigen::VectorXd divide(const Eigen::VectorXd &v) const;

    /// The units in which the natural residual in y is that in x.
    Scaling scaled(const Scaling &scaling) const;

  private:
    Eigen::VectorXd scales_;
  };
} // namespace stiction::qp

#endif
