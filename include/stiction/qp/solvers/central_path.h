#pragma once

#include <Eigen/Core>

#include <vector>

namespace stiction::qp
{
  class SlipBound;
  struct Scaling;

  /// Contact forces and what is dual to them, inside their cones, on the way to
  /// a solution.
  ///
  /// At every node the forces (λ_ν; g_i, λ_t) and their duals (w_ν; σ, w_t), the
  /// gap and the slip with a bound σ on its length, stay inside the half line
  /// times the second-order cone. On the central path λ_ν w_ν = μ and
  /// (g, λ_t)∘(σ, w_t) = (μ, 0) in the Jordan algebra of the cone, and μ → 0 leads to
  /// a solution (F. Alizadeh and D. Goldfarb, Math. Program. 95, 2003). With
  /// Coulomb friction g follows λ_ν.
  ///
  /// What couples the nodes, Q or K, is the caller's: aim() says where to, each
  /// node then has the linear condition D Δλ + Δw = c, and the caller finds the
  /// direction that satisfies it.
  class CentralPath
  {
  public:
    /// Starts with a force of scaling.force(i) at each node. Arguments must
    /// outlive the object.
    CentralPath(const SlipBound &slip_bound, const Scaling &scaling);

    /// Makes the point a central one with gaps about as large as the gradient
    /// (ν; t1; t2), which is what they have to become.
    void open_gaps(const Eigen::VectorXd &gradient);

    /// Below the first residual forces and duals are worth to begin near to them; a point
    /// of less than the second is too near to the boundary of the cones to leave it.
    static constexpr double near_residual = 0.1, least_residual = 1e-2;

    /// Makes the point the central one nearest to these forces and duals (ν; t1; t2): in
    /// their scales λ − w remains what it is, and μ is the square of their residual.
    void begin_near(const Eigen::VectorXd &lambda, const Eigen::VectorXd &w,
                    double residual);

    /// What μ is measured by: the mean product of the scales of all nodes. Unit: J.
    double unit() const;

    /// λ and w, length 3m by blocks (ν; t1; t2). Where nodes are tied λ begins at
    /// zero and goes wherever directions lead, and w is zero.
    const Eigen::VectorXd &lambda() const { return lambda_; }
    const Eigen::VectorXd &w() const { return w_; }

    /// The forces with zeros where gaps are open and on their circle where
    /// there is slip: what they approach from inside.
    Eigen::VectorXd lambda_on_boundary() const;

    /// The part of μ to aim at after a direction that aims at zero: the less, the
    /// farther that may go (S. Mehrotra, SIAM J. Optim. 2, 1992).
    double centring() const;

    /// The mean μ of all products after a step of this length in the direction, 0 if
    /// there are none. Unit: J.
    double mean_product(double length = 0.) const;

    /// Where the next direction leads to first order: to products of @p mu.
    void aim(double mu);

    /// ... and also to second order, of the direction that is known so far.
    void aim_with_correction(double mu);

    /// D of a node and c of all: zero where a node is tied, and in tangential
    /// directions without friction.
    Eigen::Matrix3d compliance(Eigen::Index i) const;
    Eigen::VectorXd right_hand_side() const;

    /// The direction, one that satisfies the conditions.
    void set_direction(const Eigen::VectorXd &lambda_change,
                       const Eigen::VectorXd &w_change);

    /// The length at which it leaves the cones.
    double largest_step() const;

    void advance(double length);

    /// Nodes that are not tied.
    const std::vector<Eigen::Index> &bounded() const { return bounded_; }

    bool has_friction(Eigen::Index i) const;

  private:
    // What a node has of forces, or of their duals: an element of the half line
    // and one of the second-order cone, (bound; two tangential components).
    struct ConePoint
    {
      double normal;
      Eigen::Vector3d cone;
    };
    ConePoint force(Eigen::Index i) const;
    void begin_near_with_friction(Eigen::Index i, const Eigen::Vector2d &a, double mu);
    ConePoint force_change(Eigen::Index i) const;
    ConePoint dual(Eigen::Index i) const;
    ConePoint dual_change(Eigen::Index i) const;
    static ConePoint product(const ConePoint &force, const ConePoint &dual);

    const SlipBound &slip_bound_;
    const Scaling &scaling_;
    const Eigen::Index m_;
    std::vector<Eigen::Index> bounded_;
    Eigen::VectorXd lambda_, w_, sigma_;
    Eigen::VectorXd lambda_change_, w_change_, sigma_change_;
    std::vector<ConePoint> changes_; // of the products, to first order
  };
} // namespace stiction::qp
